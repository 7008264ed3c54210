#!/bin/bash
# Installs what is missing of cmake/packages.txt, and of the packages named as arguments. Where
# nothing is missing it does nothing and needs no rights.
set -euo pipefail
cd "$(dirname "$0")"

if ! command -v dpkg-query >/dev/null; then
  echo "setup: no dpkg here: the packages of cmake/packages.txt, as your system names them, are up to you" >&2
  exit 0
fi

mapfile -t wanted < <(sed 's/#.*//' packages.txt | xargs -n 1; printf '%s\n' "$@")
missing=()
for package in "${wanted[@]}"; do
  [[ -z $package || $(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null) == installed ]] ||
    missing+=("$package")
done
((${#missing[@]})) || exit 0

as_root=()
if ((EUID != 0)); then
  if ! command -v sudo >/dev/null; then
    echo "setup: neither root nor sudo: have an administrator run: apt-get install --no-install-recommends ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi

# sudo clears the environment, so env comes after it.
apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y -o DPkg::Lock::Timeout=300)
echo "setup: installing ${missing[*]}"
"${apt[@]}" update </dev/null || echo "setup: apt-get update failed; trying with the lists at hand" >&2
"${apt[@]}" install --no-install-recommends "${missing[@]}" </dev/null
