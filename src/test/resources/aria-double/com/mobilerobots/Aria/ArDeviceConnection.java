package com.mobilerobots.Aria;

/** A double of a connection. */
public class ArDeviceConnection {
    public String getOpenMessage(int number) {
        return "made up";
    }

    public boolean close() {
        return true;
    }
}
