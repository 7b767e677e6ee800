package majic.pioneer.state;

import java.util.List;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import majic.pioneer.arcos.InputsOutputs;
import majic.pioneer.arcos.Sip;
import majic.pioneer.arcos.SipField;

/**
 * The controller's inputs and outputs for equipment (ARCOS sheet 8, 11.2). The user's eight digital ones are in every
 * SIP of all but the oldest firmware; all others come with the IO packet. Immutable.
 *
 * @param digitalIn the user's inputs as bits, input 0 lowest; active low
 * @param digitalOut the user's outputs as bits, output 0 lowest
 * @param analogPort the analog input the SIP shows, as chosen with ADSEL
 * @param analogVolts what that input reads, 0 to 5
 * @param allDigitalIn all bytes of inputs: the user's, front bumpers, rear bumpers, infra-reds; empty before the first
 *     report
 * @param allAnalogVolts all analog inputs, 0 to 5, the battery last; empty before the first report
 */
public record IoPorts(
        OptionalInt digitalIn,
        OptionalInt digitalOut,
        OptionalInt analogPort,
        OptionalDouble analogVolts,
        List<Integer> allDigitalIn,
        List<Double> allAnalogVolts) {
    private static final double FULL_V = 5;
    private static final double SIP_STEPS = 255;
    private static final double IO_STEPS = 1023;

    static IoPorts of(PioneerState state) {
        Sip sip = state.sip();
        InputsOutputs all =
                state.reports().latest(InputsOutputs.class).orElse(new InputsOutputs(List.of(), List.of(), List.of()));
        return new IoPorts(
                optional(sip, SipField.DIG_IN),
                optional(sip, SipField.DIG_OUT),
                optional(sip, SipField.ANALOG_PORT),
                sip.has(SipField.ANALOG)
                        ? OptionalDouble.of(sip.get(SipField.ANALOG) * FULL_V / SIP_STEPS)
                        : OptionalDouble.empty(),
                all.digitalIn(),
                all.analog().stream().map(steps -> steps * FULL_V / IO_STEPS).toList());
    }

    private static OptionalInt optional(Sip sip, SipField field) {
        return sip.has(field) ? OptionalInt.of(sip.get(field)) : OptionalInt.empty();
    }
}
