package majic.pioneer.arcos;

import java.util.List;

/**
 * The controller's ports, as many as it reports (ARCOS sheet 11.2). On a Pioneer 3 the inputs are the user's eight, the
 * front bumpers, the rear bumpers and the infra-reds, and the last analog value is the battery. Immutable.
 *
 * @param digitalIn bytes of eight inputs each, active low
 * @param digitalOut bytes of eight outputs each
 * @param analog 0 to 1023 for 0 to 5 V
 */
public record InputsOutputs(List<Integer> digitalIn, List<Integer> digitalOut, List<Integer> analog) implements Report {
    /** Keeps copies. */
    public InputsOutputs {
        digitalIn = List.copyOf(digitalIn);
        digitalOut = List.copyOf(digitalOut);
        analog = List.copyOf(analog);
    }

    static InputsOutputs read(FieldReader fields) {
        return new InputsOutputs(
                fields.ubytes(fields.ubyte()), fields.ubytes(fields.ubyte()), fields.uints(fields.ubyte()));
    }
}
