package majic.act.make;

import java.io.IOException;
import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import majic.act.ActArgument;
import majic.act.ActException;
import majic.act.FailureText;
import majic.act.MajicAct;
import majic.act.Role;
import majic.act.file.InvalidActException;

/** Makes the first object of an act's class, to save it. This runs the author's code on the author's own computer. */
final class FreshAct {
    private FreshAct() {}

    /**
     * Makes an act.
     *
     * @throws InvalidActException with what is missing or wrong in its constructor, to put behind the class's name
     */
    static MajicAct of(String actClass, ClassLoader loader) throws IOException {
        try {
            Constructor<?> constructor = Class.forName(actClass, true, loader).getDeclaredConstructor();
            constructor.setAccessible(true);
            return (MajicAct) constructor.newInstance();
        } catch (NoSuchMethodException e) {
            throw new InvalidActException("has no constructor without arguments; give it one", e);
        } catch (InvocationTargetException e) {
            throw new InvalidActException("failed in its constructor, where it has no robot yet: " + e.getCause(), e);
        } catch (ExceptionInInitializerError e) {
            throw new InvalidActException("failed in its static initialiser: " + e.getCause(), e);
        } catch (ReflectiveOperationException | LinkageError e) {
            throw new InvalidActException("cannot be made: " + e, e);
        }
    }

    /** Returns the robots that the act needs, checked. */
    static List<Role> roles(MajicAct act) throws IOException {
        List<Role> roles = rolesAsSaid(act);
        if (roles.isEmpty()) {
            throw new InvalidActException("asks for no robot in its roles()");
        }
        Set<String> names = new HashSet<>();
        for (Role role : roles) {
            if (!names.add(role.name())) {
                throw new InvalidActException("asks in its roles() for two robots of the name " + role.name());
            }
        }
        return roles;
    }

    /** Returns the arguments that the act takes, checked. */
    static List<ActArgument> arguments(MajicAct act) throws IOException {
        try {
            return List.copyOf(act.arguments());
        } catch (ActException e) {
            throw new InvalidActException("has a wrong argument: " + e.getMessage(), e);
        } catch (RuntimeException | Error e) {
            throw new InvalidActException("failed in its arguments(): " + FailureText.named(e), e);
        }
    }

    private static List<Role> rolesAsSaid(MajicAct act) throws IOException {
        try {
            return List.copyOf(act.roles());
        } catch (RuntimeException | Error e) {
            throw new InvalidActException("failed in its roles(): " + FailureText.named(e), e);
        }
    }
}
