#!/usr/bin/env bash
# Installs CalculiX, which `benchmarks -- compare` runs beside this program, from the package registry that the machine
# is set up for: apt-get, dnf, or conda. Exit status 1 with a plain message where that is not possible.
set -euo pipefail

say() { printf '%s\n' "$*"; }

refuse() {
    printf 'install_calculix.sh: %s\n' "$*" >&2
    exit 1
}

# The version that a program tells; CalculiX answers `-v` on standard output, with a status of its own.
version() { { "$1" -v 2>/dev/null || true; } | sed -n 's/.*Version *\([0-9.]*[0-9]\).*/\1/p' | head -n 1; }

found() {
    local program="${SIGNORINI_CCX:-ccx}" told
    command -v "$program" >/dev/null 2>&1 || return 1
    told=$(version "$program")
    [ -n "$told" ] || return 1
    say "CalculiX $told: $(command -v "$program")"
}

as_root() {
    if [ "$(id -u)" -eq 0 ]; then
        "$@"
    elif command -v sudo >/dev/null 2>&1; then
        sudo "$@"
    else
        refuse "\`$*\` needs the rights of root, and there is no sudo"
    fi
}

# Runs a command quietly; what it printed is shown where it fails.
quietly() {
    local printed
    if ! printed=$("$@" 2>&1); then
        printf '%s\n' "$printed" >&2
        refuse "\`$*\` failed"
    fi
}

if found; then
    say "nothing to install"
    exit 0
fi

[ -z "${SIGNORINI_CCX:-}" ] || refuse "SIGNORINI_CCX names \`$SIGNORINI_CCX\`, which is not CalculiX: mend it, or unset it"

if command -v apt-get >/dev/null 2>&1; then
    say "installing calculix-ccx by apt-get"
    quietly as_root apt-get update
    quietly as_root env DEBIAN_FRONTEND=noninteractive apt-get install --yes --no-install-recommends calculix-ccx
elif command -v dnf >/dev/null 2>&1; then
    say "installing calculix-ccx by dnf"
    quietly as_root dnf install --assumeyes calculix-ccx
elif command -v conda >/dev/null 2>&1; then
    say "installing calculix by conda"
    quietly conda install --yes --channel conda-forge calculix
else
    refuse "none of apt-get, dnf and conda is here; install CalculiX by hand, and name its program in SIGNORINI_CCX"
fi

hash -r
found || refuse "the package is installed, but no \`ccx\` is on the search path; name its program in SIGNORINI_CCX"
