#!/usr/bin/env bash
# Install the system libraries that are missing (Debian, Ubuntu).
#
#   scripts/install_system_libraries.sh runtime PYTHON   venv for PYTHON; pointloom itself loads nothing that may be missing
#   scripts/install_system_libraries.sh test PYTHON      ... and what Taichi and Open3D load, and ffmpeg
#   scripts/install_system_libraries.sh emulation PYTHON ... and gcc, with which the emulated CUDA device compiles
#   scripts/install_system_libraries.sh browser PYTHON   ... and Chromium and Mesa's llvmpipe, in which pages are tested
#
# As root they are installed with apt-get. Otherwise the line to run is printed and the script goes on with status 0:
# without libX11 Taichi does not import, without any of the others Open3D does not; tests of videos skip without ffmpeg.
set -euo pipefail

# Open3D 0.20 links against all of these, Taichi against the first; a bare Debian has only some.
test_libraries="libX11.so.6=libx11-6 libGL.so.1=libgl1 libEGL.so.1=libegl1 libusb-1.0.so.0=libusb-1.0-0 libudev.so.1=libudev1
    libidn2.so.0=libidn2-0"

case "${1:-}" in
    runtime) wanted="" ;;
    test | emulation) wanted=$test_libraries ;;
    # Chromium draws with llvmpipe through EGL, without X; where Mesa is missing, with its own SwiftShader.
    browser) wanted="$test_libraries libEGL_mesa.so.0=libegl-mesa0" ;;
    *)
        echo "usage: $0 runtime|test|emulation|browser PYTHON" >&2
        exit 2
        ;;
esac
python=${2:?"usage: $0 runtime|test|emulation|browser PYTHON"}

# Opening a library is the test that counts: it sees LD_LIBRARY_PATH and libraries that no package manager knows.
missing_packages() {
    # shellcheck disable=SC2086  # one argument a library
    "$python" -I - $wanted <<'PYTHON'
import ctypes
import sys
from importlib.util import find_spec

for pair in sys.argv[1:]:
    library, package = pair.split("=")
    try:
        ctypes.CDLL(library)
    except OSError:
        print(package)
if not find_spec("ensurepip"):
    print("python%d.%d-venv" % sys.version_info[:2])
PYTHON
}

packages=$(missing_packages | tr '\n' ' ')
packages=${packages% }
if [ "$1" != runtime ] && ! command -v ffmpeg >/dev/null 2>&1; then
    packages="$packages ffmpeg" # videos are read and written with it
fi
if [ "$1" = emulation ] && ! echo '#include <math.h>' | gcc -E - >/dev/null 2>&1; then
    packages="$packages gcc libc6-dev"
fi
# Debian's package; elsewhere any Chromium or Chrome on the path will do. tests/browser/conftest.py looks for the same.
chromium="chromium chromium-browser google-chrome google-chrome-stable chrome"
# shellcheck disable=SC2086  # one argument a name
if [ "$1" = browser ] && [ -z "${POINTLOOM_CHROMIUM:-}" ] && [ -z "$(command -v $chromium)" ]; then
    packages="$packages chromium libgl1-mesa-dri"
fi
packages=${packages# }
[ -n "$packages" ] || exit 0

install="apt-get install -y --no-install-recommends $packages"
if ! command -v apt-get >/dev/null 2>&1; then
    echo "Missing system libraries; on Debian or Ubuntu these packages contain them: $packages" >&2
    exit 0
fi
if [ "$(id -u)" != 0 ]; then
    echo "Missing system libraries. To install them:" >&2
    echo "    sudo apt-get update && sudo $install" >&2
    exit 0
fi

echo "Installing system libraries: $packages"
export DEBIAN_FRONTEND=noninteractive NEEDRESTART_MODE=a
# shellcheck disable=SC2086  # one argument a package
if ! { apt-get update -qq && apt-get install -y -qq --no-install-recommends $packages; } </dev/null >/dev/null; then
    echo "apt-get failed; continuing without $packages" >&2
fi
