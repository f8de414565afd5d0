#!/usr/bin/env bash
# One call on a GPU machine without network: unpack the archives of this call, then continue the run, as far as
# archives and time allow.
#   bash benchmarks/gpu_kit/call.sh FOLDER [SECONDS [--steps STEP ...]]
# in the repository's root; FOLDER: archives of this call, with the plan's seconds, run and steps in plan.txt.
# At the end of a call, logs, marks and partial results are written to one archive in $OUT.
# POINTLOOM_GPU_HOME is the folder for data between calls. POINTLOOM_GPU_DRY=1 uses the emulated device.
set -u
BEGIN=$SECONDS
FOLDER=${1:?the folder of the pieces of this call}
read -r PLANNED RUN STEPS <"$FOLDER/plan.txt"
TOTAL=${2:-$PLANNED}
shift $(($# < 2 ? $# : 2))
HOME_OF_RUN=${POINTLOOM_GPU_HOME:-${TMPDIR:-/tmp}/pointloom-gpu}
OUT=${OUT:-$HOME_OF_RUN/out}
IN=$HOME_OF_RUN/in SITE=$HOME_OF_RUN/site STATE=$HOME_OF_RUN/state HERE=$HOME_OF_RUN/here
mkdir -p "$IN" "$SITE" "$STATE" "$HERE" "$OUT" "$HOME_OF_RUN/start"
trap 'tar czf "$OUT/gpu-run-$(basename "$FOLDER").tar.gz" -C "$STATE" .' EXIT

cp "$FOLDER"/*.part* "$IN/" 2>/dev/null
while read -r name parts; do # archives whose parts are complete now
    have=$(find "$IN" -name "$name.part*" | wc -l)
    if [ "$have" = "$parts" ] && [ ! -e "$HERE/${name%%.*}" ]; then
        case $name in
        *.zip) cat "$IN/$name".part* >"$HOME_OF_RUN/$name" ;;
        *) cat "$IN/$name".part* | xz -dc -T0 | tar xf - -C "$SITE" ;;
        esac && touch "$HERE/${name%%.*}" && rm -f "$IN/$name".part* && echo "$name is complete after $((SECONDS - BEGIN)) s"
    fi
done <"$FOLDER/pieces.txt"

export PYTHONUNBUFFERED=1 POINTLOOM_CPU=warp WARP_CACHE_PATH=${WARP_CACHE_PATH:-$HOME_OF_RUN/cache}
export PYTHONPATH=$PWD/src:$HOME_OF_RUN/start:$SITE:${PYTHONPATH:-}
[ -e "$HERE/cpu" ] && export POINTLOOM_CPU_KERNELS=$SITE/cpu-kernels
[ -e "$HOME_OF_RUN/kernels.zip" ] && export POINTLOOM_CUDA_KERNELS=$HOME_OF_RUN/kernels.zip
[ -e "$HERE/before" ] && export POINTLOOM_GPU_BEFORE=$SITE/before
if [ -e "$HERE/open3d" ]; then # the packages of Open3D's viewers are not installed
    echo 'import open3d_stub' >"$HOME_OF_RUN/start/sitecustomize.py"
    export LD_LIBRARY_PATH=$SITE/open3d:${LD_LIBRARY_PATH:-}
fi
[ -n "$STEPS" ] || exit 0 # this call only carries archives
# shellcheck disable=SC2046,SC2086  # one word per archive and step
"${PYTHON:-python3}" benchmarks/gpu_kit --state "$STATE" --seconds $((TOTAL - (SECONDS - BEGIN) - 6)) --no-keep \
    --run "$RUN" --steps $STEPS ${POINTLOOM_GPU_DRY:+--dry} "$@" --pieces $(ls "$HERE")
