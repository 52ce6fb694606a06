#!/usr/bin/env bash
# The main job on the example track: ./demo.sh [FOLDER]   (default: out)
# Builds the program and writes the track as STEP, DXF, SVG and a PNG picture.
set -euo pipefail
cd "$(dirname "$0")"
. scripts/setup.sh

need_rust
need_linker
out="${1:-out}"
mkdir -p "$out"
cargo run --release --locked --bin cyclide -- curve examples/track.csv --closed --units m \
    -o "$out/track.step" -o "$out/track.dxf" -o "$out/track.svg" -o "$out/track.png"
