#!/usr/bin/env bash
# All tests, with all set-up: ./test.sh
# Installs what is missing, makes .venv, runs every check and ends with "N passed, M failed".
set -euo pipefail
cd "$(dirname "$0")"
trap 'echo "the set-up failed, no check was run"; echo "0 passed, 1 failed"' ERR
. scripts/setup.sh

need_rust
need_linker
need_readers
need_validator
[ -x .venv/bin/python ] || python3 -m venv .venv
.venv/bin/python -m pip install --quiet --disable-pip-version-check -r tests/foreign/requirements.txt
trap - ERR
exec .venv/bin/python tests/run_all.py
