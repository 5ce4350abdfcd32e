#!/bin/sh
# Installs the packages of packages.txt that are not there yet.
set -eu
cd "$(dirname "$0")/../.."

fail() {
    echo "setup: $*" >&2
    exit 1
}

command -v apt-get >/dev/null && command -v dpkg-query >/dev/null ||
    fail "no apt-get here: install the programs that packages.txt names" \
        "by other means"

installed() {
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

missing=
for package in $(sed 's/#.*//' packages.txt); do
    installed "$package" || missing="$missing $package"
done
if [ -z "$missing" ]; then
    echo "setup: every package of packages.txt is installed"
    exit 0
fi
echo "setup: installing$missing"

as_root=
if [ "$(id -u)" != 0 ]; then
    command -v sudo >/dev/null ||
        fail "neither root nor sudo: run as root: apt-get install$missing"
    as_root=sudo
fi

# Unquoted on purpose: $as_root may be empty, $missing is a list.
apt() {
    $as_root env DEBIAN_FRONTEND=noninteractive apt-get -q "$@"
}
apt update ||
    fail "apt-get update failed (see above): is there a network, and do the" \
        "sources of apt answer?"
apt install -y --no-install-recommends $missing ||
    fail "apt-get install failed (see above) for:$missing"
