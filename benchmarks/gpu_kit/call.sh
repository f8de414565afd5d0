#!/usr/bin/env bash
# One call on a GPU machine without network: take in what was carried, then go on with the run, as far as pieces and
# time reach.
#   bash benchmarks/gpu_kit/call.sh FOLDER [SECONDS]      in the repository's root; FOLDER: of the pieces of this call
# What is known by the end of a call lies as one archive under $OUT: logs, marks and parts of results.
# POINTLOOM_GPU_HOME is where all is kept between calls. POINTLOOM_GPU_DRY=1 tries it on the emulated device.
set -u
BEGIN=$SECONDS
FOLDER=${1:?the folder of the pieces of this call} TOTAL=${2:-570}
HOME_OF_RUN=${POINTLOOM_GPU_HOME:-${TMPDIR:-/tmp}/pointloom-gpu}
OUT=${OUT:-$HOME_OF_RUN/out}
IN=$HOME_OF_RUN/in SITE=$HOME_OF_RUN/site STATE=$HOME_OF_RUN/state HERE=$HOME_OF_RUN/here
mkdir -p "$IN" "$SITE" "$STATE" "$HERE" "$OUT" "$HOME_OF_RUN/start"
trap 'tar czf "$OUT/gpu-run-$(basename "$FOLDER").tar.gz" -C "$STATE" .' EXIT

cp "$FOLDER"/*.part* "$IN/" 2>/dev/null
while read -r name parts; do # pieces of which all parts are here now
    have=$(find "$IN" -name "$name.part*" | wc -l)
    if [ "$have" = "$parts" ] && [ ! -e "$HERE/${name%%.*}" ]; then
        case $name in
        *.zip) cat "$IN/$name".part* >"$HOME_OF_RUN/$name" ;;
        *) cat "$IN/$name".part* | xz -dc -T0 | tar xf - -C "$SITE" ;;
        esac && touch "$HERE/${name%%.*}" && rm -f "$IN/$name".part* && echo "$name is here after $((SECONDS - BEGIN)) s"
    fi
done <"$FOLDER/pieces.txt"

export PYTHONUNBUFFERED=1 POINTLOOM_CPU=warp WARP_CACHE_PATH=${WARP_CACHE_PATH:-$HOME_OF_RUN/cache}
export PYTHONPATH=$PWD/src:$HOME_OF_RUN/start:$SITE:${PYTHONPATH:-}
[ -e "$HOME_OF_RUN/kernels.zip" ] && export POINTLOOM_CUDA_KERNELS=$HOME_OF_RUN/kernels.zip
if [ -e "$HERE/open3d" ]; then # what Open3D's viewers import is not here
    echo 'import open3d_stub' >"$HOME_OF_RUN/start/sitecustomize.py"
    export LD_LIBRARY_PATH=$SITE/open3d:${LD_LIBRARY_PATH:-}
fi
# shellcheck disable=SC2046  # one word a piece
"${PYTHON:-python3}" benchmarks/gpu_kit --state "$STATE" --seconds $((TOTAL - (SECONDS - BEGIN) - 6)) --no-keep \
    ${POINTLOOM_GPU_DRY:+--dry} --pieces $(ls "$HERE")
