package majic.pioneer;

/**
 * What is drawn of a Pioneer, taken at one moment. Immutable.
 *
 * @param model its hull and where its sonars sit
 * @param state what it last said
 * @param touchedFront whether a front bumper is touched
 * @param touchedRear whether a rear bumper is touched
 * @param connected whether that is how things are now
 */
record PioneerScene(Model model, PioneerState state, boolean touchedFront, boolean touchedRear, boolean connected) {

    static PioneerScene of(Session session, boolean connected) {
        PioneerState state = session.state();
        Bumpers bumpers = Bumpers.of(session.model(), session.config());
        return new PioneerScene(session.model(), state, bumpers.front(state) != 0, bumpers.rear(state) != 0, connected);
    }
}
