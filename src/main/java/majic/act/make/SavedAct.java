package majic.act.make;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.NotSerializableException;
import java.io.ObjectOutputStream;
import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Optional;
import majic.act.FailureText;
import majic.act.MajicAct;
import majic.act.file.ActClasses;
import majic.act.file.ActObjectInput;
import majic.act.file.InvalidActException;
import org.jspecify.annotations.Nullable;

/** Writes an act to an object stream, and finds the fields that cannot be saved. */
final class SavedAct {
    private SavedAct() {}

    /**
     * Saves an act.
     *
     * @return its object stream, which can be read back
     * @throws InvalidActException if a field cannot be saved; the message names it
     */
    static byte[] of(MajicAct act, ActClasses own) throws IOException {
        try {
            byte[] stream = bytes(act);
            readBack(stream, act, own);
            return stream;
        } catch (IOException e) {
            throw new InvalidActException(badField(act, own).orElseGet(() -> reason(e)), e);
        }
    }

    private static byte[] bytes(@Nullable Object saved) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
            out.writeObject(saved);
        }
        return bytes.toByteArray();
    }

    private static void readBack(byte[] stream, MajicAct act, ActClasses own) throws IOException {
        try {
            ActObjectInput.read(stream, own::has, act.getClass().getClassLoader());
        } catch (RuntimeException | Error e) {
            throw new InvalidActException("failed in its own code when it was read: " + FailureText.named(e), e);
        }
    }

    private static Optional<String> badField(MajicAct act, ActClasses own) {
        for (Class<?> type = act.getClass(); type != MajicAct.class; type = type.getSuperclass()) {
            for (Field field : type.getDeclaredFields()) {
                Optional<String> bad = saved(field) ? problem(field, act, own) : Optional.empty();
                if (bad.isPresent()) {
                    return bad;
                }
            }
        }
        return Optional.empty();
    }

    private static boolean saved(Field field) {
        return !Modifier.isStatic(field.getModifiers()) && !Modifier.isTransient(field.getModifiers());
    }

    private static Optional<String> problem(Field field, MajicAct act, ActClasses own) {
        try {
            field.setAccessible(true);
            readBack(bytes(new ArrayList<>(Collections.singletonList(field.get(act)))), act, own);
            return Optional.empty();
        } catch (IOException e) {
            return Optional.of("cannot be saved: its field '" + field.getName() + "' " + reason(e)
                    + "; make the field transient and fill it in behave()");
        } catch (IllegalAccessException e) {
            return Optional.empty();
        }
    }

    private static String reason(IOException e) {
        return e instanceof NotSerializableException
                ? "holds a " + e.getMessage() + ", which cannot be saved"
                : String.valueOf(e.getMessage());
    }
}
