package majic.shared.desk;

import java.time.Instant;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.CopyOnWriteArrayList;
import majic.shared.message.LatchMessage;
import majic.shared.message.Sender;
import majic.team.StopOrigin;
import majic.team.Team;
import majic.team.TeamListener;
import org.jspecify.annotations.Nullable;

/**
 * The STOPs of all desks that latch one team. Each STOP has an id. The team is released when all ids that latch it are
 * released, so a release that was sent before a newer STOP does not end that one. There is one object for each team
 * that has joined a site. Thread-safe; calls no listener and stops nothing while it holds its lock, but publishes, so
 * that each broker receives STOPs and releases in the order of the changes.
 */
final class TeamLatch implements TeamListener {
    private static final Map<Team, TeamLatch> LATCHES = new HashMap<>();
    private static final int MOST_KNOWN = 1000;

    private final Team team;
    private final List<SiteLatch> sites = new CopyOnWriteArrayList<>();

    /** The STOPs that latch the team, by their ids, oldest first. */
    private final Map<String, ActiveStop> active = new LinkedHashMap<>();

    private final Set<String> unpublished = new LinkedHashSet<>();
    private final Set<String> known = new LinkedHashSet<>();
    private int stopsOfOthers;
    private int releasesOfOthers;

    /**
     * One STOP that is not released.
     *
     * @param message as another desk has published it; null for a STOP of this desk
     * @param time when this desk stopped; null for a STOP of another one, or if it is not known
     * @param latched whether it has been latched here
     */
    private record ActiveStop(
            @Nullable LatchMessage message, @Nullable Instant time, boolean latched) {
        ActiveStop takingEffect() {
            return new ActiveStop(message, time, true);
        }

        /** The STOP of another desk is published again in the name of that desk. */
        LatchMessage messageOf(String id, Sender self) {
            return message == null ? LatchMessage.stop(id, self, time) : message;
        }
    }

    private TeamLatch(Team team) {
        this.team = team;
    }

    static TeamLatch join(Team team, SiteLatch site) {
        synchronized (LATCHES) {
            TeamLatch latch = LATCHES.get(team);
            if (latch == null) {
                latch = new TeamLatch(team);
                LATCHES.put(team, latch);
                team.addListener(latch);
                team.shareStop(true);
                latch.adoptPresentLatch();
            }
            latch.sites.add(site);
            return latch;
        }
    }

    void leave(SiteLatch site) {
        synchronized (LATCHES) {
            sites.remove(site);
            if (sites.isEmpty() && LATCHES.remove(team, this)) {
                team.shareStop(false);
                team.removeListener(this);
            }
        }
    }

    /** STOP was latched before the team joined a site. */
    private synchronized void adoptPresentLatch() {
        if (team.isLatched()) {
            addOwn(null);
        }
    }

    private void addOwn(@Nullable Instant time) {
        String id = newId();
        active.put(id, new ActiveStop(null, time, true));
        unpublished.add(id);
    }

    private String newId() {
        String id = UUID.randomUUID().toString();
        know(id);
        return id;
    }

    private void know(String id) {
        known.add(id);
        if (known.size() > MOST_KNOWN) {
            known.remove(known.iterator().next());
        }
    }

    @Override
    public void latchChanged(boolean latched) {
        if (latched) {
            stopped();
        } else {
            released();
        }
    }

    /** Publishes STOP of this desk; a STOP of others has been published by them. */
    private synchronized void stopped() {
        if (stopsOfOthers > 0) {
            stopsOfOthers--;
            oldestTookEffect();
            return;
        }
        addOwn(Instant.now());
        sites.forEach(this::publishUnpublished);
    }

    /** A release that follows ends this STOP too, even if its bytes are still being written. */
    private void oldestTookEffect() {
        active.entrySet().stream()
                .filter(stop -> !stop.getValue().latched())
                .findFirst()
                .ifPresent(stop -> stop.setValue(stop.getValue().takingEffect()));
    }

    private void released() {
        if (isReleasedByOthers()) {
            if (isStoppedAgain()) {
                team.time().runAsync("STOP during a release by another desk", team::stopAll);
            }
        } else {
            publishRelease();
        }
    }

    private synchronized boolean isReleasedByOthers() {
        if (releasesOfOthers == 0) {
            return false;
        }
        releasesOfOthers--;
        return true;
    }

    /**
     * Whether a STOP was latched after a release had arrived, and before that release took effect, which ended it too.
     */
    private synchronized boolean isStoppedAgain() {
        if (active.values().stream().noneMatch(ActiveStop::latched)) {
            return false;
        }
        stopsOfOthers++;
        return true;
    }

    /** Publishes the release of what the team was stopped for; a STOP that has just arrived is not released by it. */
    private synchronized void publishRelease() {
        List<String> ids = active.entrySet().stream()
                .filter(stop -> stop.getValue().latched())
                .map(Map.Entry::getKey)
                .toList();
        active.keySet().removeAll(ids);
        unpublished.removeAll(ids);
        if (!ids.isEmpty()) {
            sites.forEach(site -> site.publishRelease(ids));
        }
    }

    /** Publishes the STOPs that could not be published before, if there is a connection now. */
    synchronized void publishUnpublished(SiteLatch site) {
        unpublished.removeIf(id -> publish(site, id));
    }

    /** Publishes the latch again, because the broker has forgotten it or others were released without this desk. */
    synchronized void repeat(SiteLatch site) {
        active.keySet().stream().findFirst().ifPresent(id -> publish(site, id));
    }

    private boolean publish(SiteLatch site, String id) {
        ActiveStop stop = active.get(id);
        return stop == null || site.publish(stop.messageOf(id, site.sender()));
    }

    void received(SiteLatch site, LatchMessage message) {
        if (message.latched()) {
            receivedStop(site, message);
        } else {
            receivedRelease(site, message);
        }
    }

    /** A STOP without an id of its own, which may be sent again after a release. */
    void receivedWithoutId(SiteLatch site, LatchMessage stop) {
        synchronized (this) {
            if (!active.containsKey(stop.id())) {
                known.remove(stop.id());
            }
        }
        receivedStop(site, stop);
    }

    private void receivedStop(SiteLatch site, LatchMessage message) {
        synchronized (this) {
            if (known.contains(message.id())) {
                return;
            }
            know(message.id());
            active.put(message.id(), new ActiveStop(message, null, false));
            stopsOfOthers++;
        }
        StopOrigin origin = new StopOrigin(message.by(), message.time());
        site.connection().time().runAsync("STOP of another desk", () -> team.stopAll(origin));
    }

    private void receivedRelease(SiteLatch site, LatchMessage message) {
        boolean latchedStill;
        synchronized (this) {
            message.releases().forEach(this::know);
            if (active.isEmpty()) {
                return;
            }
            active.keySet().removeAll(message.releases());
            unpublished.removeAll(message.releases());
            latchedStill = !active.isEmpty();
        }
        if (latchedStill) {
            repeat(site);
        } else {
            site.connection().time().runAsync("release by another desk", () -> release(message));
        }
    }

    /** A STOP may have come since the release arrived. */
    private void release(LatchMessage message) {
        synchronized (this) {
            if (!active.isEmpty()) {
                return;
            }
            releasesOfOthers++;
        }
        team.release();
        if (!team.isLatched()) {
            team.notice("released by " + message.by());
        }
    }
}
