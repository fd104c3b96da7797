# shellcheck shell=bash
# What the run.sh scripts share; they source this file. Written for bash on Debian and Ubuntu.

# What the build needs; libcgal-demo holds CGAL's data.
packages=(g++ cmake ninja-build ccache libcgal-dev libcgal-demo libeigen3-dev libtbb-dev libpng-dev)

say() {
  printf '== %s\n' "$*"
}

as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    env DEBIAN_FRONTEND=noninteractive "$@"
  elif command -v sudo >/dev/null; then
    sudo env DEBIAN_FRONTEND=noninteractive "$@"
  else
    say "neither root nor sudo: cannot run $*"
    return 1
  fi
}

# Installs those of the packages that are missing.
install_packages() {
  local package missing=()
  if ! command -v apt-get >/dev/null; then
    say "no apt-get here; going on with what is installed (needed: ${packages[*]})"
    return
  fi
  for package in "${packages[@]}"; do
    dpkg-query -W -f='${Status}\n' "$package" 2>/dev/null | grep -q '^install ok installed$' ||
      missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return
  say "installing with apt-get: ${missing[*]}"
  if ! { as_root apt-get update -qq &&
    as_root apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null; }; then
    say "that failed; going on with what is installed"
  fi
}

# Cores, or fewer if there is not enough memory: a compiler run on CGAL takes up to 2 GB.
number_of_jobs() {
  local cores memory
  cores=$(nproc)
  memory=$(awk '/^MemAvailable:/ { print int($2 / 2000000) }' /proc/meminfo 2>/dev/null || true)
  memory=${memory:-$cores}
  [ "$memory" -ge 1 ] || memory=1
  echo $((cores < memory ? cores : memory))
}

# configure SOURCE BUILD [options of cmake]: tells about the configuration only if it fails.
configure() {
  local source=$1 build=$2 generator=()
  shift 2
  mkdir -p "$build"
  if [ ! -e "$build/CMakeCache.txt" ] && command -v ninja >/dev/null; then
    generator=(-G Ninja)
  fi
  say "configuring in $build"
  if ! cmake -S "$source" -B "$build" "${generator[@]}" -DCMAKE_BUILD_TYPE=Release "$@" \
    >"$build/configure.log" 2>&1; then
    cat "$build/configure.log"
    return 1
  fi
}

# unpack_data FOLDER: CGAL's data (meshes/, points_3/, ...) into FOLDER, if it is not there yet.
unpack_data() {
  local folder=$1 archive=usr/share/doc/libcgal-dev/data.tar.gz temporary
  [ -e "$folder/complete" ] && return
  say "unpacking CGAL's data into $folder"
  mkdir -p "$folder"
  if [ -e "/$archive" ]; then
    tar -xzf "/$archive" -C "$folder" --strip-components=1 || return 1
  else # container images leave out documentation, and with it the data
    temporary=$(mktemp -d)
    if (cd "$temporary" && apt-get download -qq libcgal-demo &&
      dpkg-deb --fsys-tarfile ./*.deb | tar -xO "./$archive" >data.tar.gz) >/dev/null 2>&1; then
      tar -xzf "$temporary/data.tar.gz" -C "$folder" --strip-components=1
    fi
    rm -rf "$temporary"
  fi
  [ -e "$folder/meshes" ] && touch "$folder/complete"
}
