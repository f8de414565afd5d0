#!/usr/bin/env bash
# Make .venv in the current folder, or keep the one that is there if it works.
#
#   scripts/make_venv.sh PYTHON
set -euo pipefail

python=${1:?"usage: $0 PYTHON"}
version='import sys; print("%d.%d" % sys.version_info[:2])'

if .venv/bin/python -m pip --version >/dev/null 2>&1; then
    case "$(.venv/bin/python -c "$version")" in
        3.11 | 3.12 | 3.13 | 3.14) exit 0 ;;
    esac
fi
if ! "$python" -I -c 'import ensurepip, venv' 2>/dev/null; then
    echo "$python cannot make virtual environments. On Debian or Ubuntu:" >&2
    echo "    sudo apt-get install python$("$python" -I -c "$version")-venv" >&2
    exit 1
fi
echo "Making .venv with $("$python" --version) ($python)"
"$python" -m venv --clear .venv
