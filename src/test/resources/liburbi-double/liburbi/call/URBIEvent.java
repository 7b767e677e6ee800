package liburbi.call;

public class URBIEvent {
    private final int timestamp;
    private final String tag;
    private final String text;
    private String[] header = {};
    private byte[] binary;

    public URBIEvent(int timestamp, String tag, String text) {
        this.timestamp = timestamp;
        this.tag = tag;
        this.text = text;
        if (text.startsWith("BIN ")) {
            header = text.split(" +");
        }
    }

    public boolean isBinary() {
        return header.length > 1;
    }

    public void setBinBuffer(byte[] bytes) {
        binary = bytes;
    }

    public int getTimestamp() {
        return timestamp;
    }

    public String getTag() {
        return tag;
    }

    public String getCmd() {
        return text;
    }

    public int getSize() {
        return number(1, true);
    }

    public String getType() {
        return header.length > 2 ? header[2] : null;
    }

    public int getWidth() {
        return number(3, isPicture());
    }

    public int getHeight() {
        return number(4, isPicture());
    }

    public byte[] getBinBuffer() {
        return binary;
    }

    public float getSampleRate() {
        return number(4, !isPicture());
    }

    public int getNbOfBits() {
        return number(5, !isPicture());
    }

    public int getNbOfChannels() {
        return number(3, !isPicture());
    }

    public boolean getSigned() {
        return number(6, !isPicture()) == 1;
    }

    private boolean isPicture() {
        return "jpeg".equals(getType()) || "YCbCr".equals(getType());
    }

    private int number(int index, boolean applies) {
        return applies && header.length > index ? Integer.parseInt(header[index]) : 0;
    }
}
