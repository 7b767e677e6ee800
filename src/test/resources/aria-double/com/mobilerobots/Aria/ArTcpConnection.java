package com.mobilerobots.Aria;

/** A double of a connection over TCP. */
public class ArTcpConnection extends ArDeviceConnection {
    public int open(String host, int port) {
        return host.isEmpty() ? 1 : 0;
    }
}
