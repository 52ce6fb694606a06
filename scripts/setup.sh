# Functions that install what is missing on a Debian machine; sourced by demo.sh and test.sh.
#
# need_rust:    a Rust toolchain (never installed, only asked for)
# need_linker:  gcc and the C headers (Rust links with them)
# need_readers: python3-venv and the shared libraries that the readers of the test suite load
# need_validator: Node.js, npm and the glTF validator of tests/foreign/gltf, in its folder
# Debian packages: gcc libc6-dev python3-venv libgl1 libx11-6 libexpat1 libcairo2 nodejs npm

# Installs Debian packages as root or through sudo; says what to do where neither works.
install_packages() {
    echo "installing: $*"
    if [ "$(id -u)" = 0 ]; then
        become=""
    elif command -v sudo >/dev/null; then
        become="sudo"
    else
        echo "these Debian packages are missing and neither root nor sudo is at hand: $*" >&2
        return 1
    fi
    $become apt-get update -qq
    # shellcheck disable=SC2086  # an empty $become must vanish
    $become env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "$@"
}

# True if the dynamic linker finds a library of this name.
has_library() {
    PATH="$PATH:/sbin:/usr/sbin" ldconfig -p | grep -q "$1"
}

# The Rust toolchain must be there: it is the one thing that apt is not asked for.
need_rust() {
    if ! command -v cargo >/dev/null; then
        [ -r "$HOME/.cargo/env" ] && . "$HOME/.cargo/env"
    fi
    command -v cargo >/dev/null || {
        echo "no Rust toolchain: install 1.88 or later from https://rustup.rs" >&2
        return 1
    }
}

# A linker and the C library's headers, for the Rust build.
need_linker() {
    if ! command -v cc >/dev/null || ! [ -e /usr/include/stdio.h ]; then
        install_packages gcc libc6-dev
    fi
}

# Python's venv and the shared libraries of the readers (OpenCASCADE: GL, X11, expat; CairoSVG: cairo).
need_readers() {
    missing=""
    python3 -c 'import venv, ensurepip' 2>/dev/null || missing="$missing python3-venv"
    has_library libGL.so.1 || missing="$missing libgl1"
    has_library libX11.so.6 || missing="$missing libx11-6"
    has_library libexpat.so.1 || missing="$missing libexpat1"
    has_library libcairo.so.2 || missing="$missing libcairo2"
    # shellcheck disable=SC2086  # a list of words
    [ -z "$missing" ] || install_packages $missing
}

# Node.js and npm, and the glTF validator at the version of its lock file.
need_validator() {
    missing=""
    command -v node >/dev/null || missing="$missing nodejs"
    command -v npm >/dev/null || missing="$missing npm"
    # shellcheck disable=SC2086  # a list of words
    [ -z "$missing" ] || install_packages $missing
    if ! [ tests/foreign/gltf/node_modules/.package-lock.json -nt tests/foreign/gltf/package-lock.json ]; then
        npm ci --prefix tests/foreign/gltf --silent --no-audit --no-fund
    fi
}
