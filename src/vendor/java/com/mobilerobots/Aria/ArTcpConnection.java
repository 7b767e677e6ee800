package com.mobilerobots.Aria;

import signatures.SignatureOnly;

/** Signature: a connection over TCP; {@code open} returns 0 where it succeeded. */
public class ArTcpConnection extends ArDeviceConnection {
    public ArTcpConnection() {
        super(0, false);
    }

    public int open(String host, int port) {
        throw new SignatureOnly();
    }

    public void setPort(String host, int port) {
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
