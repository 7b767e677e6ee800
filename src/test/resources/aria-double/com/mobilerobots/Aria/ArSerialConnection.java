package com.mobilerobots.Aria;

/** A double of a connection over a serial port: there are no ports. */
public class ArSerialConnection extends ArDeviceConnection {
    public int open(String port) {
        return 1;
    }
}
