# What ./majic and ./check share: finding or installing tools, building, starting. Sourced, not run.

say() {
    echo "majic: $*" >&2
}

is_debian() {
    command -v apt-get >/dev/null 2>&1
}

# Runs a command as root, or explains how.
as_root() {
    if [ "$(id -u)" = 0 ]; then
        "$@"
    else
        sudo "$@"
    fi
}

# Whether packages can be installed; sudo asks for its password at the terminal, whatever the standard input is.
may_install() {
    is_debian || return 1
    [ "$(id -u)" = 0 ] && return 0
    command -v sudo >/dev/null 2>&1 || return 1
    sudo -n true 2>/dev/null || [ -t 2 ]
}

# install_packages PACKAGE...: installs Debian packages, and says how much there is to fetch, how far it is, and what failed.
install_packages() {
    size=$(as_root env LC_ALL=C apt-get install --assume-no --no-install-recommends "$@" 2>/dev/null |
        sed -n 's/^Need to get \(.*\) of archives.*/\1/p')
    [ -z "$size" ] || say "$size to fetch; this can take minutes"
    {
        as_root env LC_ALL=C DEBIAN_FRONTEND=noninteractive apt-get -qq install -y --no-install-recommends \
            -o APT::Status-Fd=1 "$@" 2>&1
        echo "status:$?"
    } | show_progress
}

# Reads the progress that apt-get reports, shows it on one line of a terminal, elsewhere by a line for each quarter; returns
# the status of apt-get.
show_progress() {
    shown=
    code=1
    while IFS=: read -r kind what percent rest; do
        case $kind in
            dlstatus) doing=fetching ;;
            pmstatus) doing=installing ;;
            status) code=$what ;;
            E) say "apt-get:$what${percent:+:$percent}${rest:+:$rest}" ;;
        esac
        percent=${percent%%.*}
        case $kind:$percent in
            dlstatus:*[!0-9]* | pmstatus:*[!0-9]* | dlstatus: | pmstatus:) ;;
            dlstatus:* | pmstatus:*)
                if [ -t 2 ]; then
                    printf '\rmajic: %s, %s %% ' "$doing" "$percent" >&2
                elif [ "$doing $((percent / 25))" != "$shown" ]; then
                    shown="$doing $((percent / 25))"
                    say "$doing, $percent %"
                fi
                ;;
        esac
    done
    [ ! -t 2 ] || printf '\r%-40s\r' '' >&2
    return "$code"
}

# install_or_name WHY PACKAGE...: installs Debian packages after one line that says so, or names the command.
install_or_name() {
    why=$1
    shift
    if may_install; then
        say "$why is missing; installing $*"
        as_root apt-get -qq update >/dev/null 2>&1 || true
        if install_packages "$@"; then
            return 0
        fi
        say "installing failed; try: apt-get update && apt-get install $*"
        exit 1
    fi
    if is_debian; then
        say "$why is missing; as root type: apt-get install $*"
    elif command -v brew >/dev/null 2>&1; then
        say "$why is missing; type: brew install openjdk maven"
    elif command -v dnf >/dev/null 2>&1; then
        say "$why is missing; type: sudo dnf install java-latest-openjdk-devel maven"
    elif command -v pacman >/dev/null 2>&1; then
        say "$why is missing; type: sudo pacman -S jdk-openjdk maven"
    else
        say "$why is missing; install a JDK (17 or newer) and Maven (3.8 or newer), and put both on the PATH"
    fi
    exit 1
}

# The major version of a java program, 0 if there is none.
java_major() {
    version=$("$1" -version 2>&1 | sed -n 's/.*version "\([0-9]*\).*/\1/p' | head -n 1)
    echo "${version:-0}"
}

# Chooses the java to use: JAVA_HOME's, else the one on the PATH; sets java.
find_java() {
    if [ -n "${JAVA_HOME:-}" ] && [ -x "$JAVA_HOME/bin/java" ]; then
        java=$JAVA_HOME/bin/java
    else
        java=$(command -v java || true)
    fi
}

# Whether there is a JDK that is new enough; sets java and major, its major version.
has_jdk() {
    find_java
    [ -n "$java" ] && major=$(java_major "$java") && [ "$major" -ge 17 ] && { [ -x "$(dirname "$java")/javac" ] || command -v javac >/dev/null 2>&1; }
}

need_java_and_maven() {
    has_jdk || { install_or_name "a JDK (17 or newer)" default-jdk && has_jdk; }
    command -v mvn >/dev/null 2>&1 || install_or_name Maven maven
}

# What the JDK uses to make a package; only Debian's own tools can be installed here.
need_packaging_tools() {
    is_debian || return 0
    for tool in fakeroot objcopy; do
        command -v $tool >/dev/null 2>&1 || install_or_name "what makes a .deb ($tool)" fakeroot binutils
    done
}

# Maven waits for half an hour when the network falls silent; the names are those of Maven 3.8 and of later ones.
fetch_timeouts="-Dmaven.wagon.rto=30000 -Daether.connector.requestTimeout=30000"

# fetch_problem LOG: why Maven could not fetch a file, and what helps, from what it printed; nothing if it could. The longest of
# its lines has the reason.
fetch_problem() {
    problem=$(grep 'Could not transfer artifact' "$1" |
        awk 'length > length(longest) { longest = $0 } END { print longest }' |
        sed -e 's/.*Could not transfer artifact [^ ]* from[^(]*(\([^)]*\)): \(.*\)/\1: \2/' -e 's/ -> \[Help.*//' \
            -e 's/transfer failed for [^ ]*\( @ line [0-9]*, column [0-9]*\)\{0,1\}:\{0,1\} *//' -e 's/sun\.[a-zA-Z.]*Exception: //')
    case $problem in
        '') ;;
        *PKIX*) echo "$problem; Java does not trust the certificate, perhaps that of a proxy: get it from the proxy's owner and type keytool -importcert -cacerts -file CERTIFICATE" ;;
        *) echo "$problem" ;;
    esac
}

# fetch_broker HERE: copies the libraries of the embedded broker to target/broker, which are not part of MAJIC. The folder
# gets this name when it is complete, so that a fetch that was interrupted is done again.
fetch_broker() {
    [ ! -d "$1/target/broker" ] || return 0
    say "fetching the embedded broker (100 MB) into target/broker, once; this takes a minute or more"
    part=$1/target/broker.part
    log=$1/target/broker.log
    rm -rf "$part"
    if (cd "$1" && mvn -q -B $fetch_timeouts -f src/build/broker/pom.xml "-Dmajic.broker=$part" package </dev/null >"$log" 2>&1); then
        mv "$part" "$1/target/broker"
        return 0
    fi
    reason=$(fetch_problem "$log")
    say "the embedded broker was not fetched: ${reason:-an error that $log shows}; start MAJIC again to try again, or install another broker, such as Mosquitto"
    return 1
}

# may_start_broker ADDRESS: whether MAJIC accepts --broker with this address; one that other computers reach needs a password.
may_start_broker() {
    [ -z "${MAJIC_MQTT_USER-}" ] || [ -z "${MAJIC_MQTT_PASSWORD-}" ] || return 0
    case $1 in
        localhost | localhost:* | 127.* | ::1 | "[::1]"*) return 0 ;;
        *.* | *:*) return 1 ;;
    esac
}

# fetch_wanted_broker HERE ARGUMENT...: the same if an argument is --broker, unless MAJIC will refuse its address.
fetch_wanted_broker() {
    folder=$1
    shift
    wanted=
    at=
    before=
    for argument; do
        [ "$before" != --broker ] || at=$argument
        case $argument in
            --broker) wanted=yes ;;
            --broker=*) wanted=yes at=${argument#*=} ;;
        esac
        before=$argument
    done
    if [ -n "$wanted" ] && may_start_broker "$at"; then
        fetch_broker "$folder" || true
    fi
}

# exec_packaging HERE: makes an image and an installer of MAJIC, in place of this process.
exec_packaging() {
    say "making an image and an installer in target/package; this takes a minute"
    exec "$java" -Djava.awt.headless=true -cp "$1/target/majic.jar" "$1/src/build/Packaging.java" "$1"
}

# Builds the jar, saying once that it does and what it is at.
build_majic() {
    say "building; the first time this fetches libraries and takes a minute or two"
    log=$1/target/build.log
    mkdir -p "$1/target"
    terminal=
    [ ! -t 2 ] || terminal=yes
    (cd "$1" && mvn -B $fetch_timeouts -Dmaven.test.skip -Dspotless.check.skip -Dcheckstyle.skip -Dmaven.javadoc.skip -Dmaven.source.skip package 2>&1) |
        tee "$log" |
        awk -v "terminal=$terminal" '
            /Downloaded from/ { n++ }
            /Downloaded from/ && terminal { printf "\rmajic: %d files fetched", n > "/dev/stderr" }
            /Downloaded from/ && !terminal && n % 100 == 0 { print "majic: " n " files fetched" > "/dev/stderr" }
            /^\[INFO\] --- / && terminal { sub(/^\[INFO\] --- /, ""); sub(/ @.*/, ""); printf "\rmajic: %-60s", $0 > "/dev/stderr" }
            END { if (terminal) printf "\r%-70s\r", "" > "/dev/stderr" }'
    if ! grep -q 'BUILD SUCCESS' "$log"; then
        problem=$(fetch_problem "$log")
        if [ -n "$problem" ]; then
            say "a library cannot be fetched: $problem"
        else
            grep '^\[ERROR\]' "$log" | head -n 5 >&2
        fi
        say "the build failed; all of it stands in $log"
        exit 1
    fi
    touch "$1/target/majic.jar"
}

# Where class data is kept that makes the next start faster.
cache_folder() {
    echo "${XDG_CACHE_HOME:-$HOME/.cache}/majic"
}

# The file of class data of this jar and JDK. Named after the jar's path, since that of another jar cannot be used.
class_data_archive() {
    echo "$(cache_folder)/majic-$major-$(id -u)-$(echo "$jar" | cksum | tr ' ' -).jsa"
}

# Makes the class data in the background, for the next start. Nothing is compiled meanwhile: a method that waits for
# compilation when the archive is written would never be compiled in the programs that use the archive.
make_class_data() {
    fresh=$archive.$$
    (nice "$java" "-XX:ArchiveClassesAtExit=$fresh" $native -Xint -XX:+UseSerialGC -Xlog:disable -jar "$jar" class-data &&
        mv -f "$fresh" "$archive" || rm -f "$fresh") >/dev/null 2>&1 </dev/null &
}

# find_aria_libraries ARGUMENT...: lets the system find the library that ARIA's wrapper needs, which Java cannot do for it.
find_aria_libraries() {
    aria=${ARIA-}
    before=
    for argument; do
        [ "$before" != --aria-home ] || aria=$argument
        case $argument in --aria-home=*) aria=${argument#*=} ;; esac
        before=$argument
    done
    for folder in "$aria" "$aria/lib" "$aria/lib64"; do
        if [ -n "$aria" ] && [ -f "$folder/libAria.so" ]; then
            LD_LIBRARY_PATH=$(cd "$folder" && pwd)${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
            export LD_LIBRARY_PATH
        fi
    done
}

# exec_majic HERE ARGUMENT...: starts MAJIC in place of this process, with what is open as 3 for its standard input.
exec_majic() {
    jar=$1/target/majic.jar
    options=$1/config/java.options
    shift
    find_aria_libraries "$@"
    native=
    [ "$major" -lt 22 ] || native=--enable-native-access=ALL-UNNAMED
    # On X11, a key that arrives while a thread that draws waits for the display is noticed only when Java asks for events
    # again, by default after up to half a second. F12 must not wait that long; the value is in ms.
    export _AWT_MAX_POLL_TIMEOUT="${_AWT_MAX_POLL_TIMEOUT:-10}"
    archive=$(class_data_archive)
    if [ -f "$archive" ] && [ "$archive" -nt "$jar" ]; then
        exec "$java" "-XX:SharedArchiveFile=$archive" $native "@$options" -Xlog:disable \
            -jar "$jar" "$@" <&3 3<&-
    fi
    if mkdir -p "$(cache_folder)" 2>/dev/null; then
        make_class_data
    fi
    exec "$java" $native "@$options" -jar "$jar" "$@" <&3 3<&-
}
