package majic.pioneer.session;

/** What a person is told when a handshake comes to nothing, by what was heard instead of a Pioneer. */
final class ConnectErrors {
    private ConnectErrors() {}

    static String telnet(String address) {
        return "what answers at " + address
                + " speaks telnet (RFC 2217), which garbles packets; can its serial server be set to raw TCP?";
    }

    static String hungUp(String address, FirstBytes heard) {
        String line = heard.line();
        return address + " closed the connection in the handshake"
                + (line == null ? "" : ", saying \"" + line + "\"")
                + "; a Pioneer takes one program at a time, so is another one connected to it?";
    }

    static String nothingCameOfIt(String address, FirstBytes heard, int seconds) {
        String line = heard.line();
        if (heard.isSilence()) {
            return "no Pioneer answers at " + address + " within " + seconds + " s";
        }
        return "something answers at " + address + ", but not as a Pioneer does"
                + (line == null ? "" : "; it says \"" + line + "\"")
                + "; is it the right port" + (line == null ? ", and its speed the robot's?" : "?");
    }
}
