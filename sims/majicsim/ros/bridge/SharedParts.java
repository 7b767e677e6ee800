package majicsim.ros.bridge;

import majicsim.ros.graph.RosNetwork;
import majicsim.ros.message.JsonForm;
import majicsim.ros.message.RosVersion;
import majicsim.ros.options.RosOptions;

/** What all clients of one bridge share. */
record SharedParts(
        RosNetwork network,
        RosOptions options,
        BridgeFaults faults,
        JsonForm form,
        Publishers publishers,
        Subscribers subscribers,
        Goals goals,
        Runnable clientsChanged) {
    RosVersion version() {
        return options.version();
    }
}
