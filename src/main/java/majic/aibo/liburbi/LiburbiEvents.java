package majic.aibo.liburbi;

import java.util.List;
import liburbi.call.URBIEvent;
import majic.aibo.urbi.UrbiMessage;
import majic.aibo.urbi.UrbiValue;

/** Turns the library's events into messages. */
final class LiburbiEvents {
    private LiburbiEvents() {}

    /** Reads an event, which the library may change afterwards. */
    static UrbiMessage message(URBIEvent event) {
        byte[] bytes = event.getBinBuffer();
        if (bytes != null) {
            return UrbiMessage.of(
                    event.getTimestamp(), event.getTag(), new UrbiValue.Binary(header(event), bytes.clone()));
        }
        String text = event.getCmd();
        return UrbiMessage.of(event.getTimestamp(), event.getTag(), text == null ? "" : text);
    }

    /** The type and parameters of a binary, as a server prints them (URBI sheet 12). */
    private static List<String> header(URBIEvent event) {
        String type = String.valueOf(event.getType());
        if (event.getWidth() > 0) {
            return List.of(type, "" + event.getWidth(), "" + event.getHeight());
        }
        if (event.getSampleRate() > 0) {
            return List.of(
                    type,
                    "" + event.getNbOfChannels(),
                    "" + Math.round(event.getSampleRate()),
                    "" + event.getNbOfBits(),
                    event.getSigned() ? "1" : "2");
        }
        return List.of(type);
    }
}
