# What demos/run and tests/run share: installing what is missing, and building. To be sourced in
# the repository's root.

# Debian 12's names. What builds and draws; then what tests it.
packages=(g++ cmake ninja-build pkg-config libeigen3-dev libglm-dev libstb-dev libgl-dev libegl-dev
    libdeflate-dev libavcodec-dev libavformat-dev libavutil-dev libswscale-dev libosmesa6
    fonts-inter catch2 libgmp-dev)

fail() { echo "$0: $*" >&2; exit 2; }

since() { awk "BEGIN { print $EPOCHREALTIME - $1 }"; }

# One line of name and seconds; the output only if it fails.
stage() {
    local name=$1 start=$EPOCHREALTIME status=0; shift
    mkdir -p build
    "$@" >build/stage.log 2>&1 </dev/null || status=$?
    printf '%-44s %7.1f s\n' "$name" "$(since "$start")"
    ((!status)) || { cat build/stage.log; echo "FAILED: $name"; }
    return "$status"
}

# Debian packages; elsewhere the tools themselves decide.
install() {
    if ! command -v apt-get >/dev/null; then
        [[ -f build/build.ninja ]] ||
            echo "Not a Debian system; needed, by Debian's names: $*"
        for tool in cmake ninja g++; do
            command -v $tool >/dev/null || fail "$tool is missing"
        done
        return
    fi
    local missing=() root=() package
    for package; do
        [[ $(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null) == installed ]] ||
            missing+=("$package")
    done
    ((${#missing[@]})) || return 0
    local line="apt-get install -y --no-install-recommends ${missing[*]}"
    if ((EUID)); then
        root=(sudo)
        [[ -t 0 ]] || root+=(-n)
        "${root[@]}" true 2>/dev/null || fail "packages are missing; as root: $line"
    fi
    local apt=("${root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=300)
    stage "package lists" "${apt[@]}" update || true
    stage "install ${#missing[@]} packages" \
        "${apt[@]}" install -y --no-install-recommends "${missing[@]}" || fail "as root: $line"
    touch CMakeLists.txt  # so that builds look again for what there is
}

configure() {  # PRESET FOLDER; ninja repeats it when a CMakeLists.txt changes
    [[ -f $2/build.ninja ]] || stage "configure $1" cmake --preset "$1"
}

build() {  # PRESET FOLDER [TARGET]...
    local preset=$1 folder=$2; shift 2
    configure "$preset" "$folder" &&
        stage "build $preset" cmake --build "$folder" ${1+--target "$@"} && checkKernels "$folder"
}

# A weak function outside the namespace of its instruction set may be the copy that the linker keeps
# for every processor.
checkKernels() {
    local isa shared
    for isa in v3 v4; do
        shared=$(find "$1/core/CMakeFiles/kernels_$isa.dir" -name '*.o' -exec nm -C --defined-only {} + |
            grep ' W ' | grep -v "plait::$isa::" || true)
        if [[ $shared ]]; then
            echo "$1: shared functions compiled for $isa:"
            echo "$shared"
            return 1
        fi
    done
}
