#!/bin/sh
# Runs Gradle: the one on PATH where it serves, else the pinned distribution, else Debian's package. Says which.
set -eu

pinned=8.11.1
pinned_sha256=f397b287023acdba1e9f6fc5ea72d22dd63669d59ed4a289a29b1a76eee151c6
pinned_url=https://services.gradle.org/distributions/gradle-$pinned-bin.zip

project=$(dirname "$(readlink -f "$0" 2>/dev/null || echo "$0")")
. "$project/gradle/jdk.sh"

# In the plain locale Java finds no class in a folder whose name is not all ASCII.
case ${LC_ALL:-${LC_CTYPE:-${LANG:-C}}} in
    C | POSIX)
        LC_ALL=C.UTF-8
        export LC_ALL
        ;;
esac

say() {
    echo "gradlew: $*" >&2
}

# The version of the Gradle installed in folder $1, from the names of its jars.
gradle_version() {
    for core in "$1"/lib/gradle-core-[0-9]*.jar; do
        if [ -f "$core" ]; then
            core=${core##*/gradle-core-}
            echo "${core%.jar}"
            break
        fi
    done
}

# The newest Java that Gradle $1 runs on (docs.gradle.org, compatibility matrix); fails for a Gradle that does not
# serve: before 7.3 none runs on 17, save Debian's patched 4.4.1, and 9 is not verified with this build.
newest_java_for() {
    case $1 in
        4.4.1) [ "$2" = /usr/share/gradle ] && echo 17 ;;
        7.[34] | 7.[34].* | 7.[34]-*) echo 17 ;;
        7.5 | 7.5[.-]*) echo 18 ;;
        7.[6-9]* | 8.[012] | 8.[012][.-]*) echo 19 ;;
        8.[34] | 8.[34][.-]*) echo 20 ;;
        8.[567] | 8.[567][.-]*) echo 21 ;;
        8.[89] | 8.[89][.-]*) echo 22 ;;
        8.1[0123] | 8.1[0123][.-]*) echo 23 ;;
        8.1[4-9]*) echo 24 ;;
        *) return 1 ;;
    esac
}

# Runs the Gradle in folder $1 with the rest as arguments, if it serves and a Java for it is there; else returns.
run() {
    folder=$1
    shift
    version=$(gradle_version "$folder")
    if ! newest=$(newest_java_for "$version" "$folder"); then
        say "Gradle ${version:-of unknown version} in $folder does not serve: 7.3 to 8 or Debian's 4.4.1 would"
        return
    fi
    if ! JAVA_HOME=$(find_java 17 "$newest" javac); then
        JAVA_HOME=$java_home_given
        say "Gradle $version needs a JDK from 17 to $newest; installed: $(installed_java)"
        return
    fi
    export JAVA_HOME
    say "Gradle $version in $folder on JDK $(java_version "$JAVA_HOME") in $JAVA_HOME"
    counts=$(mktemp)
    trap 'rm -f "$counts"' EXIT
    code=0
    start "$folder" -p "$project" "-PtestCounts=$counts" "$@" || code=$?
    # The sum over all modules, as the last line.
    awk '{ passed += $1; failed += $3; skipped += $5 }
        END { if (NR) printf "%d passed, %d failed, %d skipped\n", passed, failed, skipped }' "$counts"
    exit "$code"
}

# Starts the Gradle in folder $1. Debian's own script prints Java's version each time, so its launcher is called.
start() {
    folder=$1
    shift
    if [ "$folder" = /usr/share/gradle ]; then
        # shellcheck disable=SC2086
        "$JAVA_HOME/bin/java" --add-opens java.base/java.lang=ALL-UNNAMED ${JAVA_OPTS:-} ${GRADLE_OPTS:-} \
            -Dorg.gradle.appname=gradlew -classpath "$folder/lib/gradle-launcher-$version.jar" \
            org.gradle.launcher.GradleMain "$@"
    else
        "$folder/bin/gradle" "$@"
    fi
}

run_gradle_on_path() {
    if on_path=$(command -v gradle); then
        on_path=$(readlink -f "$on_path" 2>/dev/null || echo "$on_path")
        run "${on_path%/bin/gradle}" "$@"
    fi
}

# Prints the folder of the pinned distribution, downloaded and checked where it is not there yet.
pinned_folder() {
    cache=${XDG_CACHE_HOME:-$HOME/.cache}/sofas
    folder=$cache/gradle-$pinned
    if [ ! -x "$folder/bin/gradle" ]; then
        mkdir -p "$cache"
        fresh=$(mktemp -d "$cache/download.XXXXXX")
        if ! download "$fresh/gradle.zip" || ! unpack "$fresh"; then
            rm -rf "$fresh"
            return 1
        fi
        # another gradlew may have been faster
        [ -x "$folder/bin/gradle" ] || mv "$fresh/gradle-$pinned" "$folder"
        rm -rf "$fresh"
    fi
    echo "$folder"
}

download() {
    say "fetching $pinned_url"
    if command -v curl >/dev/null; then
        curl -fsSL --connect-timeout 10 -o "$1" "$pinned_url" >&2 || return 1
    elif command -v wget >/dev/null; then
        wget -q --connect-timeout=10 --tries=1 -O "$1" "$pinned_url" >&2 || return 1
    else
        say "neither curl nor wget to fetch it with"
        return 1
    fi
    if command -v sha256sum >/dev/null; then
        sum=$(sha256sum "$1")
    else
        sum=$(shasum -a 256 "$1")
    fi
    if [ "${sum%% *}" != "$pinned_sha256" ]; then
        say "its SHA-256 is ${sum%% *} but must be $pinned_sha256; not used"
        return 1
    fi
}

unpack() {
    if command -v unzip >/dev/null; then
        unzip -q "$1/gradle.zip" -d "$1" >&2
    else
        (cd "$1" && "$(find_java 8 99 javac)/bin/jar" xf gradle.zip >&2 && chmod +x "gradle-$pinned/bin/gradle")
    fi
}

install_package() {
    command -v apt-get >/dev/null || return 1
    packages='gradle openjdk-17-jdk-headless'
    if [ -n "${SOFAS_NO_INSTALL:-}" ] && [ "$SOFAS_NO_INSTALL" != 0 ]; then
        say "SOFAS_NO_INSTALL forbids to install $packages by apt-get"
        return 1
    fi
    if [ "$(id -u)" = 0 ]; then
        as_root=
    elif command -v sudo >/dev/null && sudo -n true 2>/dev/null; then
        as_root='sudo -n'
    else
        say "apt-get could install it, but needs root's rights: sudo apt-get install $packages"
        return 1
    fi
    say "no Gradle and JDK here can build SOFAS: installing Debian's packages $packages by apt-get" \
        "(SOFAS_NO_INSTALL=1 forbids it)"
    # standard output lists what it unpacks; errors remain
    # shellcheck disable=SC2086
    $as_root apt-get update -qq >/dev/null &&
        $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends \
            $packages >/dev/null
}

java_home_given=${JAVA_HOME:-}

run_gradle_on_path "$@"
if find_java 17 "$(newest_java_for "$pinned" '')" javac >/dev/null; then
    if folder=$(pinned_folder); then
        run "$folder" "$@"
    fi
    say "the pinned Gradle $pinned could not be obtained"
fi
if install_package; then
    run_gradle_on_path "$@"
fi
say "no Gradle that serves: put Gradle 7.3 to 8 on PATH, with a JDK 17; installed Java: $(installed_java)"
exit 1
