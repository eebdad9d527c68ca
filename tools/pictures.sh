#!/usr/bin/env bash
# Makes the pictures of README, pages and site again, in docs: tools/pictures.sh [--times] [BIN, usually build/release/bin].
# With --times also those that show times, which takes a quarter of an hour on a machine without other work.
set -euo pipefail
cd "$(dirname "$0")/.."
times=
if [ "${1:-}" = --times ]; then times=yes && shift; fi
bin=$PWD/${1:-build/release/bin}
meshes=$PWD/build/data/meshes # see ./check
scaling=$PWD/comparisons/benchmark/scaling.py
cd docs

"$bin/example_associations" . >/dev/null
"$bin/example_curvature" >curvature.svg
"$bin/example_multigrid" multigrid.svg >/dev/null
"$bin/example_picture" >picture.svg
"$bin/example_tessellations" >tessellations.svg
"$bin/example_tessellations" "$meshes/elephant.off" 85 >elephant.svg
"$bin/example_tessellations" "$meshes/hand.off" 85 >hand.svg
"$bin/example_thin_shells" 3 thin_shells.svg >/dev/null

# A page in a browser.
page=$(mktemp -d)
trap 'rm -r "$page"' EXIT
"$bin/example_figures" "$page" >/dev/null
"$bin/kith" view "$page/t_shape.obj" -s catmull-clark,doo-sabin -o "$page/page.html" >/dev/null
chromium --headless=new --no-sandbox --use-angle=swiftshader --enable-unsafe-swiftshader --hide-scrollbars \
    --window-size=1000,620 --virtual-time-budget=5000 --screenshot=view.png "file://$page/page.html" 2>/dev/null

# Four cubes.
"$bin/kith" picture - -s catmull-clark,doo-sabin -n 0,1,2,3 --color parent --view 25,30 --size 1000x460 -o levels.svg <<'END'
OFF 20 18 0
0 0 0  1 0 0  2 0 0  3 0 0  0 1 0  1 1 0  2 1 0  3 1 0  1 -1 0  2 -1 0
0 0 1  1 0 1  2 0 1  3 0 1  0 1 1  1 1 1  2 1 1  3 1 1  1 -1 1  2 -1 1
4 10 11 15 14  4 11 12 16 15  4 12 13 17 16  4 18 19 12 11
4 0 4 5 1  4 1 5 6 2  4 2 6 7 3  4 8 1 2 9
4 0 1 11 10  4 8 9 19 18  4 2 3 13 12  4 1 8 18 11  4 9 2 12 19
4 3 7 17 13  4 7 6 16 17  4 6 5 15 16  4 5 4 14 15  4 4 0 10 14
END

cd ..
python3 tools/thesis_page.py "${bin#"$PWD/"}"

if [ $times ]; then
    cd docs
    "$bin/benchmark" --schemes catmull-clark --sizes 4000,18000,74000,295000,1200000,4700000 --plot sizes.svg
    "$scaling" "$bin" --levels 6 --repeats 3 --output /dev/shm --plot scaling.svg
fi
