#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Runs one test of the page: run.sh logic | FILE_test.mjs. If it cannot run, it says what is missing.
set -eu
if [ ! -d "$HAPTICUT_WEB/node_modules" ] || [ ! -f "$HAPTICUT_PAGE/index.html" ]; then
  echo "SKIPPED: the page was not built, because npm fetched nothing; run npm ci in apps/page/web and build again."
  exit 0
fi
if [ "$1" = logic ]; then
  cd "$HAPTICUT_WEB"
  "$HAPTICUT_NODE" node_modules/typescript/bin/tsc --noEmit
  "$HAPTICUT_NODE" build.mjs --tests
  exec "$HAPTICUT_NODE" --test build/tests/*_test.mjs
fi
if [ ! -x "$HAPTICUT_CHROMIUM" ]; then
  echo "SKIPPED: there is no chromium; install it with scripts/install-deps.sh --for test."
  exit 0
fi
exec "$HAPTICUT_NODE" --test "$(dirname "$0")/$1"
