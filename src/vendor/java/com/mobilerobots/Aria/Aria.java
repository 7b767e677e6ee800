package com.mobilerobots.Aria;

import signatures.SignatureOnly;

/** Signature: start and end of the library, once in a process. */
public class Aria {
    /** What the library does with signals; a class, not an enum, as SWIG makes it. */
    public static final class SigHandleMethod {
        public static final SigHandleMethod SIGHANDLE_SINGLE = new SigHandleMethod("SIGHANDLE_SINGLE", 0);
        public static final SigHandleMethod SIGHANDLE_THREAD = new SigHandleMethod("SIGHANDLE_THREAD", 1);
        public static final SigHandleMethod SIGHANDLE_NONE = new SigHandleMethod("SIGHANDLE_NONE", 2);

        private final String name;
        private final int value;

        private SigHandleMethod(String name, int value) {
            this.name = name;
            this.value = value;
        }

        public int swigValue() {
            return value;
        }

        @Override
        public String toString() {
            return name;
        }
    }

    public static void init(SigHandleMethod method) {
        throw new SignatureOnly();
    }

    public static void init(SigHandleMethod method, boolean initSockets, boolean sigHandleExitNotShutdown) {
        throw new SignatureOnly();
    }

    public static void uninit() {
        throw new SignatureOnly();
    }

    public static void shutdown() {
        throw new SignatureOnly();
    }

    public static boolean getRunning() {
        throw new SignatureOnly();
    }

    public static void setDirectory(String directory) {
        throw new SignatureOnly();
    }

    public static String getDirectory() {
        throw new SignatureOnly();
    }
}
