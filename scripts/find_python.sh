#!/usr/bin/env bash
# Print the path of the interpreter that pointloom's virtual environment is made with.
#
#   scripts/find_python.sh           the first of python3.13, python3.12, python3.11, python3.14, python3 that is 3.11
#                                    to 3.14, which constraints/ has packages for; one that can make virtual
#                                    environments before one that cannot
#   scripts/find_python.sh NAME      NAME alone, or an error that says what is wrong with it
set -euo pipefail

describe='import sys, sysconfig
from importlib.util import find_spec
supported = (3, 11) <= sys.version_info < (3, 15) and sys.implementation.name == "cpython"
supported = supported and not sysconfig.get_config_var("Py_GIL_DISABLED")
venv = bool(find_spec("venv") and find_spec("ensurepip"))
print(int(supported), int(venv), "%d.%d" % sys.version_info[:2], sys.executable)'

# A name on PATH may be a launcher's stub that does not run, so each one is asked.
ask() {
    command -v "$1" >/dev/null 2>&1 && "$1" -I -c "$describe" 2>/dev/null </dev/null
}

if [ -n "${1:-}" ]; then
    if ! answer=$(ask "$1"); then
        echo "PYTHON=$1 does not run; name a Python 3.11, 3.12, 3.13 or 3.14, such as PYTHON=python3.12" >&2
        exit 1
    fi
    read -r supported _ version path <<<"$answer"
    if [ "$supported" != 1 ]; then
        echo "PYTHON=$1 is Python $version ($path); constraints/ has packages for CPython 3.11, 3.12, 3.13 and 3.14" >&2
        exit 1
    fi
    echo "$path"
    exit 0
fi

without_venv=""
for name in python3.13 python3.12 python3.11 python3.14 python3; do
    answer=$(ask "$name") || continue
    read -r supported venv _ path <<<"$answer"
    [ "$supported" = 1 ] || continue
    if [ "$venv" = 1 ]; then
        echo "$path"
        exit 0
    fi
    without_venv=${without_venv:-$path}
done

if [ -n "$without_venv" ]; then
    echo "$without_venv"
    exit 0
fi
cat >&2 <<'TEXT'
No Python 3.11, 3.12, 3.13 or 3.14 on PATH. To get one:
    Debian 12       sudo apt-get install python3 python3-venv
    Ubuntu 22.04    sudo apt-get install python3.11 python3.11-venv
or name one that lies elsewhere: make PYTHON=/path/to/python3.12 setup
TEXT
exit 1
