package com.mobilerobots.Aria;

import signatures.SignatureOnly;

/** Signature: a connection over a serial port; {@code open} returns 0 where it succeeded. */
public class ArSerialConnection extends ArDeviceConnection {
    public ArSerialConnection() {
        super(0, false);
    }

    public int open(String port) {
        throw new SignatureOnly();
    }

    public void setPort(String port) {
        throw new SignatureOnly();
    }

    public boolean setBaud(int baud) {
        throw new SignatureOnly();
    }

    public int getBaud() {
        throw new SignatureOnly();
    }

    @Override
    public int getStatus() {
        throw new SignatureOnly();
    }

    @Override
    public String getOpenMessage(int number) {
        throw new SignatureOnly();
    }

    @Override
    public boolean openSimple() {
        throw new SignatureOnly();
    }

    @Override
    public boolean close() {
        throw new SignatureOnly();
    }
}
