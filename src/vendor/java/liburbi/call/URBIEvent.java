package liburbi.call;

import signatures.SignatureOnly;

/** Signature: a message of the server; numbers that it has not read 0, texts null. */
public class URBIEvent {
    public int getTimestamp() {
        throw new SignatureOnly();
    }

    public String getTag() {
        throw new SignatureOnly();
    }

    public String getCmd() {
        throw new SignatureOnly();
    }

    public int getSize() {
        throw new SignatureOnly();
    }

    public String getType() {
        throw new SignatureOnly();
    }

    public int getWidth() {
        throw new SignatureOnly();
    }

    public int getHeight() {
        throw new SignatureOnly();
    }

    public byte[] getBinBuffer() {
        throw new SignatureOnly();
    }

    public float getSampleRate() {
        throw new SignatureOnly();
    }

    public int getNbOfBits() {
        throw new SignatureOnly();
    }

    public int getNbOfChannels() {
        throw new SignatureOnly();
    }

    public boolean getSigned() {
        throw new SignatureOnly();
    }
}
