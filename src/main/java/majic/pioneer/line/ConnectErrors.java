package majic.pioneer.line;

import majic.driver.FirstBytes;

/** Messages about a handshake that failed, by what was received instead of a Pioneer's answers. */
final class ConnectErrors {
    private ConnectErrors() {}

    static String telnet(String address) {
        return "what answers at " + address
                + " speaks telnet (RFC 2217), which garbles packets; can its serial server be set to raw TCP?";
    }

    static String echo(String address) {
        return address + " sends back what it receives, and no robot answers; is it another port, or a plug that joins"
                + " both directions?";
    }

    static String hungUp(String address, FirstBytes received) {
        String line = received.line();
        return address + " closed the connection in the handshake"
                + (line == null ? "" : ", saying \"" + line + "\"")
                + "; a Pioneer takes one program at a time, so is another one connected to it?";
    }

    static String nothingCameOfIt(String address, FirstBytes received, int seconds) {
        String line = received.line();
        if (received.isEmpty()) {
            return "no Pioneer answers at " + address + " within " + seconds + " s";
        }
        return "something answers at " + address + ", but not as a Pioneer does"
                + (line == null ? "" : "; it says \"" + line + "\"")
                + "; is it the right port" + (line == null ? ", and its speed the robot's?" : "?");
    }
}
