import majic.aibo.MajicAibo;

/** An Aibo without window, team or script. */
public final class Dog {
    private Dog() {}

    /**
     * Walks up to what is ahead, looks to the left, and lies down.
     *
     * @param args where the dog is, for instance {@code aibo://192.168.1.20}
     */
    public static void main(String[] args) {
        if (args.length != 1) {
            System.err.println("usage: Dog ADDRESS, such as aibo://192.168.1.20");
            return;
        }
        try (MajicAibo dog = new MajicAibo(args[0])) {
            dog.connect();
            System.out.println(dog.move(500, () -> dog.get("distanceFront").number() < 250));
            dog.set("headPan", 45);
            dog.set("posture", "lay");
        }
    }
}
