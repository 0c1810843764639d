# shellcheck shell=sh
# Finds installed Java; read by gradlew and sofas.

# The feature version (8, 17, 25) of the Java in home $1, from its release file where it has one: asking java costs
# a twentieth of a second.
java_version() {
    version=
    if [ -f "$1/release" ]; then
        version=$(sed -n 's/^JAVA_VERSION="\(.*\)"$/\1/p' "$1/release")
    fi
    if [ -z "$version" ]; then
        version=$("$1/bin/java" -version 2>&1 | sed -n 's/.* version "\([^"]*\)".*/\1/p')
    fi
    version=${version#1.}
    echo "${version%%[!0-9]*}"
}

# The home of the Java that program $1 belongs to, links followed.
java_home_of() {
    program=$(readlink -f "$1" 2>/dev/null) || program=$1
    echo "${program%/bin/java}"
}

# Homes to look at, one a line, the user's choice first.
java_homes() {
    if [ -n "${JAVA_HOME:-}" ]; then
        echo "$JAVA_HOME"
    fi
    if java_on_path=$(command -v java); then
        java_home_of "$java_on_path"
    fi
    for home in "${HOME:-}"/.jdks/* "${HOME:-}"/.sdkman/candidates/java/* \
            /usr/lib/jvm/* /opt/java/* /opt/jdk* /Library/Java/JavaVirtualMachines/*/Contents/Home; do
        if [ -x "$home/bin/java" ]; then
            echo "$home"
        fi
    done
}

# The first home with a version from $1 to $2 that has the program $3 (java or javac); fails where there is none.
find_java() {
    java_homes | while IFS= read -r home; do
        if [ -x "$home/bin/java" ] && [ -x "$home/bin/$3" ]; then
            found=$(java_version "$home")
            if [ -n "$found" ] && [ "$found" -ge "$1" ] && [ "$found" -le "$2" ]; then
                echo "$home"
                break
            fi
        fi
    done | grep .
}

# What is installed, for messages: "17 (/usr/lib/jvm/java-17)", comma-separated.
installed_java() {
    java_homes | while IFS= read -r home; do
        if [ -x "$home/bin/java" ]; then
            kind=
            [ -x "$home/bin/javac" ] || kind=" without compiler"
            echo "$(java_version "$home") ($home$kind)"
        fi
    done | awk '!seen[$0]++ { printf "%s%s", n++ ? ", " : "", $0 } END { if (!n) printf "none" }'
}
