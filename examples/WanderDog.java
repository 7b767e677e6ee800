import majic.aibo.MajicAibo;
import majic.bot.MajicBot;

/** Lets an Aibo wander: ahead until an obstacle is near, then to the side where its head detects more room. */
public final class WanderDog {
    private WanderDog() {}

    /**
     * Walks a number of stretches.
     *
     * @param args the robot's address, for instance {@code aibo://192.168.1.20}, and how many stretches
     */
    public static void main(String[] args) {
        if (args.length != 2) {
            System.err.println("usage: WanderDog ADDRESS STRETCHES, such as aibo://192.168.1.20 5");
            return;
        }
        try (MajicAibo dog = new MajicAibo(args[0])) {
            dog.connect();
            for (int left = Integer.parseInt(args[1]); left > 0; left--) {
                wander(dog);
            }
        }
    }

    static void wander(MajicBot dog) {
        dog.move(2000, () -> dog.get("distanceFront").number() < 300);
        double left = room(dog, 70);
        double right = room(dog, -70);
        dog.set("headPan", 0);
        dog.turn(left > right ? 100 : -100);
    }

    private static double room(MajicBot dog, double degrees) {
        dog.set("headPan", degrees);
        return dog.get("distance").number();
    }
}
