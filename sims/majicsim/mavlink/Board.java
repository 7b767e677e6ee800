package majicsim.mavlink;

import majicsim.world.Noise;

/** The parts that vehicles of all kinds have. */
record Board(
        VehicleKind kind,
        Announcements announcements,
        Boot boot,
        Parameters parameters,
        RadioControl radio,
        Battery battery,
        PositionFilter filter,
        GroundStationWatch groundStation) {

    /** The parts of a vehicle with this system id. */
    static Board of(VehicleOptions options, int system, Noise noise) {
        VehicleKind kind = options.kind();
        Announcements announcements = new Announcements();
        Boot boot = new Boot(options.isReady(), announcements);
        Parameters parameters = new Parameters(kind, system);
        return new Board(
                kind,
                announcements,
                boot,
                parameters,
                new RadioControl(parameters, boot, kind == VehicleKind.COPTER),
                new Battery(parameters, announcements),
                new PositionFilter(noise.fork("gps")),
                new GroundStationWatch());
    }

    double parameter(String name) {
        return parameters.get(name);
    }
}
