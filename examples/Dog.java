import majic.aibo.MajicAibo;

/** Moves an Aibo without window, team or script. */
public final class Dog {
    private Dog() {}

    /**
     * Walks up to an obstacle ahead, turns the head to the left, and lies down.
     *
     * @param args the robot's address, for instance {@code aibo://192.168.1.20}
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
