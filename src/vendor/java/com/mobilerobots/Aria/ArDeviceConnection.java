package com.mobilerobots.Aria;

import signatures.SignatureOnly;

/** Signature: a connection to a robot. */
public class ArDeviceConnection {
    public ArDeviceConnection(long pointer, boolean owned) {
        throw new SignatureOnly();
    }

    public int getStatus() {
        throw new SignatureOnly();
    }

    public String getStatusMessage(int number) {
        throw new SignatureOnly();
    }

    public String getOpenMessage(int number) {
        throw new SignatureOnly();
    }

    public boolean openSimple() {
        throw new SignatureOnly();
    }

    public boolean close() {
        throw new SignatureOnly();
    }

    public String getPortName() {
        throw new SignatureOnly();
    }

    public String getPortType() {
        throw new SignatureOnly();
    }

    public void delete() {
        throw new SignatureOnly();
    }
}
