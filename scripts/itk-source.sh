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
# usage: itk-source.sh VERSION FOLDER
# Unpacks the source of an ITK release into FOLDER. It is Debian's source package of the distribution under development,
# from the mirror that this machine gets its packages from; nothing else comes from there.
set -euo pipefail

version=$1
folder=$2
package=insighttoolkit5

mirror=$(apt-get indextargets --format '$(REPO_URI) $(COMPONENT) $(CODENAME)' 'Created-By: Packages' |
  awk '$2 == "main" && $1 ~ /\/debian\/$/ { print $1; exit }')
if [ -z "$mirror" ]; then
  echo "itk-source.sh: no Debian mirror among the entries of apt; unpack ITK $version into $folder yourself" >&2
  exit 1
fi

work=$(mktemp -d "$(dirname "$folder")/itk-source.XXXXXX")
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/lists/partial" "$work/cache/archives/partial"
echo "deb-src $mirror sid main" > "$work/sources.list"
options=(
  -qq
  -o "Dir::Etc::SourceList=$work/sources.list" -o Dir::Etc::SourceParts=-
  -o "Dir::State::Lists=$work/lists" -o "Dir::Cache=$work/cache"
  -o "APT::Sandbox::User=$(id -un)"
)
apt-get "${options[@]}" update
found=$(apt-cache "${options[@]}" showsrc "$package" | awk '$1 == "Version:" { print $2 }' | grep -F "$version-" | tail -n 1) || true
if [ -z "$found" ]; then
  echo "itk-source.sh: Debian has no $package $version any more; unpack ITK $version into $folder yourself" >&2
  exit 1
fi
echo "Getting $package $found from $mirror"
(cd "$work" && apt-get "${options[@]}" source --download-only --only-source "$package=$found")

mkdir "$work/source"
# ITK's test data are most of it
tar -xf "$work/${package}_$version.orig.tar.xz" -C "$work/source" --strip-components=1 --exclude='*/.ExternalData'
mv "$work/source" "$folder"
