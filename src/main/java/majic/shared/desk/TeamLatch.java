package majic.shared.desk;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.CopyOnWriteArrayList;
import majic.shared.message.LatchMessage;
import majic.team.Team;
import majic.team.TeamListener;

/**
 * The STOPs of all desks that latch one team. Each STOP has an id. The team is released when all ids that latch it are
 * released, so a release that was sent before a newer STOP does not end that one. There is one object for each team that
 * has joined a site. Thread-safe; calls no listener and stops nothing while it holds its lock.
 */
final class TeamLatch implements TeamListener {
    private static final Map<Team, TeamLatch> LATCHES = new HashMap<>();
    private static final int MOST_KNOWN = 1000;

    private final Team team;
    private final List<SiteLatch> sites = new CopyOnWriteArrayList<>();

    /** The ids that latch the team, oldest first, each with whether its STOP has been latched. */
    private final Map<String, Boolean> active = new LinkedHashMap<>();

    private final Set<String> unpublished = new LinkedHashSet<>();
    private final Set<String> known = new LinkedHashSet<>();
    private int stopsOfOthers;
    private int releasesOfOthers;

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
                team.removeListener(this);
            }
        }
    }

    /** STOP was latched before the team joined a site. */
    private synchronized void adoptPresentLatch() {
        if (team.isLatched()) {
            String id = newId();
            active.put(id, true);
            unpublished.add(id);
        }
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
    private void stopped() {
        String id;
        synchronized (this) {
            if (stopsOfOthers > 0) {
                stopsOfOthers--;
                oldestTookEffect();
                return;
            }
            id = newId();
            active.put(id, true);
            unpublished.add(id);
        }
        sites.forEach(this::publishUnpublished);
    }

    /** A release that follows ends this STOP too, even if its bytes are still being written. */
    private void oldestTookEffect() {
        active.entrySet().stream().filter(stop -> !stop.getValue()).findFirst().ifPresent(stop -> stop.setValue(true));
    }

    /** Publishes the release of what the team was stopped for; a STOP that has just arrived is not released by it. */
    private void released() {
        List<String> ids = new ArrayList<>();
        synchronized (this) {
            if (releasesOfOthers > 0) {
                releasesOfOthers--;
                return;
            }
            active.forEach((id, done) -> {
                if (done) {
                    ids.add(id);
                }
            });
            active.keySet().removeAll(ids);
            unpublished.removeAll(ids);
        }
        if (!ids.isEmpty()) {
            sites.forEach(site -> site.publishRelease(ids));
        }
    }

    /** A connection exists again: publishes a STOP that could not be published before. */
    void connected(SiteLatch site) {
        publishUnpublished(site);
    }

    private void publishUnpublished(SiteLatch site) {
        List<String> ids;
        synchronized (this) {
            ids = List.copyOf(unpublished);
        }
        ids.forEach(id -> {
            if (site.publishStop(id)) {
                synchronized (this) {
                    unpublished.remove(id);
                }
            }
        });
    }

    /** Publishes the latch again, because the broker has forgotten it or others were released without this desk. */
    void repeat(SiteLatch site) {
        String id;
        synchronized (this) {
            if (active.isEmpty()) {
                return;
            }
            id = active.keySet().iterator().next();
        }
        site.publishStop(id);
    }

    void received(SiteLatch site, LatchMessage message) {
        if (message.latched()) {
            receivedStop(site, message);
        } else {
            receivedRelease(site, message);
        }
    }

    private void receivedStop(SiteLatch site, LatchMessage message) {
        synchronized (this) {
            if (known.contains(message.id())) {
                return;
            }
            know(message.id());
            active.put(message.id(), false);
            stopsOfOthers++;
        }
        site.connection().time().runAsync("STOP of another desk", () -> {
            team.stopAll();
            team.notice("STOP by " + message.by());
        });
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
            releasesOfOthers += latchedStill ? 0 : 1;
        }
        if (latchedStill) {
            repeat(site);
        } else {
            site.connection().time().runAsync("release by another desk", () -> release(message));
        }
    }

    /** A STOP may have come before the release takes effect; it is carried out again then. */
    private void release(LatchMessage message) {
        synchronized (this) {
            if (!active.isEmpty()) {
                releasesOfOthers--;
                return;
            }
        }
        team.release();
        boolean stoppedAgain;
        synchronized (this) {
            stoppedAgain = !active.isEmpty();
            stopsOfOthers += stoppedAgain ? 1 : 0;
        }
        if (stoppedAgain) {
            team.stopAll();
        } else {
            team.notice("released by " + message.by());
        }
    }
}
