package majicsim.pioneer;

import com.fazecast.jSerialComm.SerialPort;
import java.io.IOException;
import java.util.Arrays;

/**
 * A client that has opened the robot's pseudo-terminal as a serial port, at the 9600 baud of a robot just switched on.
 */
final class SerialClientWire implements Wire {
    private static final int TIMEOUT_MS = 60_000;

    private final SerialPort port;
    private final String path;

    SerialClientWire(String path) throws IOException {
        this.path = path;
        port = SerialPort.getCommPort(path);
        port.setComPortTimeouts(SerialPort.TIMEOUT_READ_BLOCKING, TIMEOUT_MS, 0);
        port.setBaudRate(9600);
        if (!port.openPort()) {
            throw new IOException("cannot open " + path);
        }
    }

    @Override
    public String key() {
        return path;
    }

    @Override
    public void write(byte[] bytes) throws IOException {
        if (port.writeBytes(bytes, bytes.length) != bytes.length) {
            throw new IOException("cannot write to " + path);
        }
    }

    @Override
    public byte[] read(int count) {
        byte[] bytes = new byte[count];
        int length = count == 0 ? 0 : port.readBytes(bytes, count);
        return Arrays.copyOf(bytes, Math.max(0, length));
    }

    @Override
    public void baud(int bitsPerSecond) {
        port.setBaudRate(bitsPerSecond);
    }

    @Override
    public void vanish() {
        port.closePort();
    }

    @Override
    public boolean isNoticed() {
        return false;
    }
}
