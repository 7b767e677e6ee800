package majicsim.aibo;

/** What the stick's CLIENT.INI leaves running in each connection: a line for every percent that the battery loses. */
final class PowerMonitor extends Task {
    private final Battery battery;
    private int shown = 101;

    PowerMonitor(Context context, Battery battery) {
        super(context);
        this.battery = battery;
    }

    @Override
    protected boolean advance() {
        int percent = battery.percent();
        if (percent < shown) {
            shown = percent;
            context.info("Battery at " + percent + " %");
        }
        return false;
    }
}
