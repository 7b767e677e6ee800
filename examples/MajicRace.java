import java.util.List;
import java.util.concurrent.CompletableFuture;
import majic.aibo.MajicAibo;
import majic.bot.MajicBot;
import majic.hemisson.MajicHemisson;
import majic.pioneer.MajicPioneer;

/** Lets three different robots race side by side, each on its own thread. */
public final class MajicRace {
    private MajicRace() {}

    /**
     * Runs the race over 500 mm; a robot with an obstacle ahead stops earlier.
     *
     * @param args the addresses of the Aibo, the Pioneer and the Hemisson
     */
    public static void main(String[] args) {
        if (args.length != 3) {
            System.err.println("usage: MajicRace AIBO PIONEER HEMISSON, the addresses of the three");
            return;
        }
        try (MajicAibo aibo = new MajicAibo(args[0]);
                MajicPioneer pioneer = new MajicPioneer(args[1]);
                MajicHemisson hemisson = new MajicHemisson(args[2])) {
            List<MajicBot> racers = List.of(aibo, pioneer, hemisson);
            racers.forEach(MajicBot::connect);
            aibo.set("posture", "stand");
            racers.stream().map(MajicRace::start).toList().forEach(CompletableFuture::join);
        }
    }

    private static CompletableFuture<Void> start(MajicBot racer) {
        return CompletableFuture.runAsync(() -> race(racer), task -> new Thread(task).start());
    }

    private static void race(MajicBot racer) {
        double near = racer.get("near").number();
        System.out.println(racer.type().label() + ": "
                + racer.move(500, () -> racer.get("distanceFront").number() < near));
    }
}
