package com.mobilerobots.Aria;

/** A double of the library's start. */
public class Aria {
    public static final class SigHandleMethod {
        public static final SigHandleMethod SIGHANDLE_NONE = new SigHandleMethod();
    }

    public static void init(SigHandleMethod method) {}

    public static void setDirectory(String directory) {}
}
