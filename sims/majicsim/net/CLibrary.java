package majicsim.net;

import com.sun.jna.LastErrorException;
import com.sun.jna.Library;
import com.sun.jna.Memory;

/** The few functions of the C library that a pseudo-terminal needs; a failure comes as an exception with its errno. */
interface CLibrary extends Library {
    int posix_openpt(int flags) throws LastErrorException;

    int grantpt(int master) throws LastErrorException;

    int unlockpt(int master) throws LastErrorException;

    String ptsname(int master) throws LastErrorException;

    int open(String path, int flags) throws LastErrorException;

    int close(int descriptor) throws LastErrorException;

    int fcntl(int descriptor, int command, Object... flags) throws LastErrorException;

    int tcgetattr(int descriptor, Memory termios) throws LastErrorException;

    int tcsetattr(int descriptor, int when, Memory termios) throws LastErrorException;

    void cfmakeraw(Memory termios);

    int cfgetospeed(Memory termios);

    int poll(Memory descriptors, int count, int timeoutMs) throws LastErrorException;

    int read(int descriptor, byte[] into, int count) throws LastErrorException;

    int write(int descriptor, byte[] from, int count) throws LastErrorException;
}
