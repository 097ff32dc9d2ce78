#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Makes the Unity package: bindings/unity, bindings/csharp, the library for Linux on x86-64, and the libraries that it needs
# and that are not part of every system. The result is a folder for a project's Packages/.
#
#   scripts/package-unity.sh [--library FILE] [--out FOLDER] [--jobs N]
#
#   --library FILE  an existing libhapticut_c.so; without it, builds one without file formats, which need 40 more
#                   libraries
#   --out FOLDER    the folder of the package [out/unity/org.hapticut.unity]; its old content is removed
#   --jobs N        number of parallel compilers [one per processor]
set -euo pipefail
cd "$(dirname "$0")/.."

library=
out=out/unity/org.hapticut.unity
jobs=$(nproc)
while [ $# -gt 0 ]; do
  case $1 in
    --library | --out | --jobs)
      [ $# -ge 2 ] || { echo "package-unity.sh: $1 needs a value." >&2; exit 2; }
      declare "${1#--}=$2"
      shift
      ;;
    -h | --help)
      sed -n '3,/^set/s/^# \{0,1\}//p' "scripts/${0##*/}" | sed '/^set/d'
      exit 0
      ;;
    *)
      echo "package-unity.sh: unknown option $1; see scripts/package-unity.sh --help." >&2
      exit 2
      ;;
  esac
  shift
done

if [ -z "$library" ]; then
  cmake -S . -B build/unity -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_UNITY_BUILD=ON -DHAPTICUT_WITH_C=ON \
    -DHAPTICUT_WITH_IO=OFF -DHAPTICUT_WITH_VIEW=OFF -DHAPTICUT_WITH_CLI=OFF -DHAPTICUT_WITH_TESTS=OFF \
    -DHAPTICUT_WITH_BENCHMARKS=OFF -DHAPTICUT_WITH_EXAMPLES=OFF >/dev/null
  cmake --build build/unity -j "$jobs" -t hapticut_c
  library=build/unity/src/c/libhapticut_c.so
fi
[ -f "$library" ] || { echo "package-unity.sh: there is no $library." >&2; exit 1; }

rm -rf "$out"
mkdir -p "$out"
cp -r bindings/unity/. "$out"
rm -r "$out/Tests~" # only for this repository
mkdir -p "$out/Runtime/Binding"
cp bindings/csharp/*.cs "$out/Runtime/Binding"
plugins=$out/Runtime/Plugins/Linux/x86_64
mkdir -p "$plugins"
cp -L "$library" "$plugins/libhapticut_c.so"
cp LICENSE "$out/LICENSE.md"

# Libraries that every system has are not included: the process must use its own C and C++ runtimes.
system='linux-vdso|ld-linux|libc\.so|libm\.so|libdl\.so|libpthread\.so|librt\.so|libresolv\.so|libstdc\+\+\.so|libgcc_s\.so'
notices=$out/ThirdPartyNotices.md
echo '# Third-party libraries in this package' >"$notices"
ldd "$plugins/libhapticut_c.so" | grep -vE "$system" | awk '$2 == "=>" { print $3 }' | while read -r needed; do
  [ -f "$needed" ] || { echo "package-unity.sh: the library needs $needed, which does not exist." >&2; exit 1; }
  cp -L "$needed" "$plugins/"
  package=$(dpkg-query -S "$(readlink -f "$needed")" 2>/dev/null | head -n 1 | cut -d: -f1) || true
  if [ -n "$package" ] && [ -f "/usr/share/doc/$package/copyright" ]; then
    printf '\n## %s (%s)\n\n```\n' "$(basename "$needed")" "$package" >>"$notices"
    cat "/usr/share/doc/$package/copyright" >>"$notices"
    printf '\n```\n' >>"$notices"
  fi
done

# Unity ignores files without a .meta file when the package is in a read-only folder. The guid of an asset is the same in
# every package, so references to it stay valid.
meta() {
  local path=$1 name=${1#"$out"/} importer
  case $path in
    *.cs) importer='MonoImporter:\n  serializedVersion: 2' ;;
    *.asmdef) importer='AssemblyDefinitionImporter:\n  externalObjects: {}' ;;
    *.so*) importer='PluginImporter:\n  serializedVersion: 2\n  isPreloaded: 0\n  platformData:\n  - first:\n      Any:\n    second:\n      enabled: 0\n  - first:\n      Editor: Editor\n    second:\n      enabled: 1\n      settings:\n        CPU: x86_64\n        OS: Linux\n  - first:\n      Standalone: Linux64\n    second:\n      enabled: 1\n      settings:\n        CPU: x86_64' ;;
    *) importer='DefaultImporter:\n  externalObjects: {}' ;;
  esac
  [ -d "$path" ] && importer='folderAsset: yes\nDefaultImporter:\n  externalObjects: {}'
  printf 'fileFormatVersion: 2\nguid: %s\n%b\n' "$(printf 'org.hapticut.unity/%s' "$name" | md5sum | cut -c1-32)" \
    "$importer" >"$path.meta"
}
find "$out" -mindepth 1 -not -path '*~*' -not -name '*.meta' -print0 | while IFS= read -r -d '' path; do meta "$path"; done

# The loader must find the needed libraries next to this library, for any folder of the project.
inside=$(cd "$plugins" && pwd -P)
elsewhere=$(env -u LD_LIBRARY_PATH ldd "$inside/libhapticut_c.so" | grep -vE "$system" | grep -vF "$inside/" || true)
if [ -n "$elsewhere" ]; then
  printf 'package-unity.sh: these libraries would not come from the package:\n%s\n' "$elsewhere" >&2
  exit 1
fi
echo "$out: $(find "$plugins" -name '*.so*' -not -name '*.meta' | wc -l) libraries, $(du -sm "$out" | cut -f1) MB"
