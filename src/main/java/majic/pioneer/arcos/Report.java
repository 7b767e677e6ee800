package majic.pioneer.arcos;

/** A packet that the robot sends only on request, beside its SIPs: its fields as sent (ARCOS sheet 11). Immutable. */
public interface Report {}
