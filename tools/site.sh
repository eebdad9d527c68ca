#!/usr/bin/env bash
# site.sh: builds the site of the documentation into build/site, with the reference by Doxygen in it. Look at it with
# `python3 -m http.server -d build/site`; search needs a server.
set -euo pipefail
cd "$(dirname "$0")/.."
roots=(include schemes adapters distributed io picture docs/Doxyfile)
reference=build/reference/html
mkdir -p build
if [ ! -f $reference/index.html ] || [ -n "$(find "${roots[@]}" -type f -newer $reference/index.html -print -quit)" ]; then
    doxygen docs/Doxyfile
fi
python3 tools/site_pages.py build/site-source
mkdocs build --quiet --clean --config-file docs/mkdocs.yml
cp -r $reference build/site/reference
