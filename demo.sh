#!/usr/bin/env bash
# The main jobs on the example track and roof: ./demo.sh [FOLDER]   (default: out)
# Builds the program and writes the track as STEP, DXF, SVG and a PNG picture, the roof as STEP, GLB and a PNG picture.
set -euo pipefail
cd "$(dirname "$0")"
. scripts/setup.sh

need_rust
need_linker
out="${1:-out}"
mkdir -p "$out"
cargo run --release --locked --bin cyclide -- curve examples/track.csv --closed --units m \
    -o "$out/track.step" -o "$out/track.dxf" -o "$out/track.svg" -o "$out/track.png"
cargo run --release --locked --bin cyclide -- build examples/roof.json \
    -o "$out/roof.step" -o "$out/roof.glb" -o "$out/roof.png"
