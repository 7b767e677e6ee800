package com.mobilerobots.Aria;

/** A double of the library's start. */
public class Aria {
    public static final class SigHandleMethod {
        public static final SigHandleMethod SIGHANDLE_NONE = new SigHandleMethod();
    }

    public static void init(SigHandleMethod method) {}

    /** The library adds the names of its folders to the end of this. */
    public static void setDirectory(String directory) {
        if (!directory.endsWith("/") || !new java.io.File(directory, "params").isDirectory()) {
            throw new IllegalArgumentException(directory);
        }
    }
}
