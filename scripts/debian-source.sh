#!/usr/bin/env bash
#==========================================================================
#
#   Copyright NumFOCUS
#
#   Licensed under the Apache License, Version 2.0 (the "License");
#   you may not use this file except in compliance with the License.
#   You may obtain a copy of the License at
#
#          https://www.apache.org/licenses/LICENSE-2.0.txt
#
#   Unless required by applicable law or agreed to in writing, software
#   distributed under the License is distributed on an "AS IS" BASIS,
#   WITHOUT WARRANTIES OR CONDITIONS OF ANY KIND, either express or implied.
#   See the License for the specific language governing permissions and
#   limitations under the License.
#
#==========================================================================
# usage: debian-source.sh PACKAGE VERSION FOLDER [SUITE]
# Unpacks the source of a Debian package into FOLDER, as its authors released it, without Debian's patches. It comes from
# the mirror that this machine gets its packages from, of the machine's own distribution or of SUITE; nothing else comes
# from there.
set -euo pipefail

package=$1
version=$2
folder=$3
suite=${4:-}

fail() {
  echo "debian-source.sh: $1; unpack $package $version into $folder yourself" >&2
  exit 1
}
command -v apt-get > /dev/null || fail "there is no apt here"
work=$(mktemp -d "$(dirname "$folder")/$package.XXXXXX")
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/lists/partial" "$work/cache/archives/partial"
apt-get indextargets --format '$(REPO_URI) $(CODENAME) $(COMPONENT)' 'Created-By: Packages' |
  awk -v suite="$suite" '$1 ~ /\/(debian|ubuntu)\/$/ && ($3 == "main" || $3 == "universe") {
    print "deb-src", $1, suite ? suite " main" : $2 " " $3
  }' | sort -u > "$work/sources.list"
[ -s "$work/sources.list" ] || fail "no Debian mirror among the entries of apt"
options=(
  -qq
  -o "Dir::Etc::SourceList=$work/sources.list" -o Dir::Etc::SourceParts=-
  -o "Dir::State::Lists=$work/lists" -o "Dir::Cache=$work/cache"
  -o "APT::Sandbox::User=$(id -un)"
)
apt-get "${options[@]}" update
found=$(apt-cache "${options[@]}" showsrc "$package" | awk '$1 == "Version:" { print $2 }' | grep -F "$version-" | tail -n 1) || true
[ -n "$found" ] || fail "Debian has no $package $version any more"
echo "Getting $package $found"
(cd "$work" && apt-get "${options[@]}" source --download-only --only-source "$package=$found")

mkdir "$work/source"
# ITK's test data are most of it
tar -xf "$work/${package}_$version".orig.tar.* -C "$work/source" --strip-components=1 --exclude='*/.ExternalData'
mv "$work/source" "$folder"
