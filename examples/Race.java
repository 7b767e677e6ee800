import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import majic.aibo.MajicAibo;
import majic.bot.MajicBot;
import majic.hemisson.MajicHemisson;
import majic.pioneer.MajicPioneer;

/** Lets three different robots race side by side, each on its own thread. */
public final class Race {
    private Race() {}

    /**
     * Runs the race over 200 mm.
     *
     * @param args the addresses of the Aibo, the Pioneer and the Hemisson
     * @throws InterruptedException if it is interrupted meanwhile
     * @throws ExecutionException if a robot did not arrive
     */
    public static void main(String[] args) throws InterruptedException, ExecutionException {
        if (args.length != 3) {
            System.err.println("usage: Race AIBO PIONEER HEMISSON, the addresses of the three");
            return;
        }
        List<MajicBot> racers = List.of(new MajicAibo(args[0]), new MajicPioneer(args[1]), new MajicHemisson(args[2]));
        ExecutorService lanes = Executors.newFixedThreadPool(racers.size());
        try {
            racers.forEach(MajicBot::connect);
            for (var arrival : lanes.invokeAll(racers.stream()
                    .map(racer -> (Callable<String>) () -> racer.type().label() + ": " + racer.move(200))
                    .toList())) {
                System.out.println(arrival.get());
            }
        } finally {
            lanes.shutdown();
            racers.forEach(MajicBot::close);
        }
    }
}
