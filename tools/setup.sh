# What ./check and ./demo have in common; they source it at the root of the project.

as_root() {
    if [ "$(id -u)" -eq 0 ]; then "$@"; else sudo "$@"; fi
}

# install_packages build check: what tools/packages.txt lists for these, as far as it is missing.
install_packages() {
    local package purpose missing=()
    while read -r package purpose; do
        case "$package" in '' | '#'*) continue ;; esac
        case " $* " in *" $purpose "*) ;; *) continue ;; esac
        if [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" != installed ]; then
            missing+=("$package")
        fi
    done <tools/packages.txt
    if [ ${#missing[@]} -eq 0 ]; then
        return
    fi
    echo "Installing ${missing[*]}"
    as_root apt-get update -qq
    as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
}

# Makes a locale that writes a comma in numbers, for the test that files are the same there; it is skipped where none can be had.
make_locale() {
    if ! locale -a | grep -qi '^de_DE\.utf-\?8$'; then
        as_root localedef -i de_DE -f UTF-8 de_DE.UTF-8 || echo "A locale with a decimal comma cannot be made; going on without it"
    fi
}

# Puts the meshes that CGAL's documentation comes with into build/data/meshes, and its examples of subdivision into
# build/data/examples. They are in a documentation package whose files many machines leave out when it is installed, so it
# is unpacked here instead. What needs them is skipped where they cannot be had.
unpack_meshes() {
    local data=build/data documents=/usr/share/doc/libcgal-dev
    if [ -d $data/meshes ] && [ -d $data/examples ]; then
        return
    fi
    mkdir -p $data
    if [ ! -f $documents/data.tar.gz ] || [ ! -f $documents/examples.tar.gz ]; then
        echo "Downloading CGAL's meshes and examples (libcgal-demo)"
        documents=$data/package$documents
        if ! apt-cache show libcgal-demo >/dev/null 2>&1; then
            as_root apt-get update -qq || true
        fi
        if ! (cd $data && apt-get download -qq libcgal-demo 2>/dev/null && dpkg-deb -x libcgal-demo_*.deb package); then
            echo "CGAL's meshes and examples cannot be had; going on without them"
            return
        fi
    fi
    mkdir -p $data/unpacked
    tar -xzf $documents/data.tar.gz -C $data/unpacked
    tar -xzf $documents/examples.tar.gz -C $data/unpacked examples/Subdivision_method_3
    rm -rf $data/meshes $data/examples
    mv $data/unpacked/data/meshes $data/meshes
    mv $data/unpacked/examples $data/examples
    rm -rf $data/unpacked $data/package $data/libcgal-demo_*.deb
}
