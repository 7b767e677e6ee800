package majic.shared.desk;

import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.CopyOnWriteArrayList;
import majic.bot.BotException;
import majic.shared.broker.PublicationRefused;
import majic.shared.message.LatchMessage;
import majic.shared.message.Sender;
import majic.team.SharedStop;
import majic.team.StopOrigin;
import majic.team.Team;
import org.jspecify.annotations.Nullable;

/**
 * The STOPs of all desks that latch one team. Each STOP has an id. The team is released when all ids that latch it are
 * released, so a release that was sent before a newer STOP does not end that one. There is one object for each team
 * that has joined a site. Thread-safe; calls no listener and stops nothing while it holds its lock, but publishes, so
 * that each broker receives STOPs and releases in the order of the changes.
 */
final class TeamLatch implements SharedStop {
    private static final Map<Team, TeamLatch> LATCHES = new HashMap<>();
    private static final int MOST_KNOWN = 1000;

    private final Team team;
    private final List<SiteLatch> sites = new CopyOnWriteArrayList<>();

    /** The STOPs that latch the team, by their ids, oldest first. */
    private final Map<String, ActiveStop> active = new LinkedHashMap<>();

    private final Set<String> known = new LinkedHashSet<>();
    private final Set<Release> releases = new HashSet<>();

    /** Why the STOP of this desk has not reached a site. */
    private final Map<SiteLatch, String> unreached = new LinkedHashMap<>();

    private int stopsOfOthers;
    private int releasesTakingEffect;

    /** One STOP that is not released. */
    private static final class ActiveStop {
        /** As another desk has published it; null for a STOP of this desk. */
        private final @Nullable LatchMessage message;

        /** When this desk stopped; null for a STOP of another one, or if it is not known. */
        private final @Nullable Instant time;

        /** The sites that it has come from, or was published at and not refused. */
        private final Set<SiteLatch> sites = new HashSet<>();

        /** Whether it has been latched here. */
        private boolean latched;

        ActiveStop(@Nullable LatchMessage message, @Nullable Instant time) {
            this.message = message;
            this.time = time;
            this.latched = message == null;
        }

        boolean isUnpublished(SiteLatch site) {
            return message == null && !sites.contains(site);
        }

        /** The STOP of another desk is published again in the name of that desk. */
        LatchMessage messageOf(String id, Sender self) {
            return message == null ? LatchMessage.stop(id, self, time) : message;
        }
    }

    /** A release of this desk that the brokers have not answered. */
    private static final class Release {
        private final List<String> ids;
        private final Runnable decided;
        private int open;

        /** Why it was not taken; empty if it was. */
        private String refusal = "";

        /** Whether it was published for certain: by this desk or, with the same ids, by another one. */
        private boolean received;

        Release(List<String> ids, Runnable decided) {
            this.ids = ids;
            this.decided = decided;
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
                team.shareStop(latch);
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
                team.shareStop(null);
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
        active.put(newId(), new ActiveStop(null, time));
    }

    private String newId() {
        String id = UUID.randomUUID().toString();
        addKnown(id);
        return id;
    }

    private void addKnown(String id) {
        known.add(id);
        if (known.size() > MOST_KNOWN) {
            known.remove(known.iterator().next());
        }
    }

    @Override
    public void latchChanged(boolean latched) {
        if (latched) {
            stopped();
        } else if (isStoppedAgain()) {
            team.time().runAsync("STOP during a release", team::stopAll);
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
        active.values().stream().filter(stop -> !stop.latched).findFirst().ifPresent(stop -> stop.latched = true);
    }

    /** Whether a STOP was latched after a release was decided, and before that release took effect, which ended it. */
    private synchronized boolean isStoppedAgain() {
        if (releasesTakingEffect == 0) {
            return false;
        }
        releasesTakingEffect--;
        if (active.values().stream().noneMatch(stop -> stop.latched)) {
            return false;
        }
        stopsOfOthers++;
        return true;
    }

    /** Publishes the STOPs that could not be published at a site before, if there is a connection now. */
    synchronized void publishUnpublished(SiteLatch site) {
        active.forEach((id, stop) -> {
            if (stop.isUnpublished(site)) {
                publish(site, id, stop);
            }
        });
    }

    /** Publishes the latch again, because the broker has forgotten it or others were released without this desk. */
    synchronized void repeat(SiteLatch site) {
        active.entrySet().stream().findFirst().ifPresent(stop -> publish(site, stop.getKey(), stop.getValue()));
    }

    private void publish(SiteLatch site, String id, ActiveStop stop) {
        if (site.publish(stop.messageOf(id, site.sender()), problem -> stopPublished(site, stop, problem))) {
            stop.sites.add(site);
        } else {
            report(site, site.stopWaits());
        }
    }

    private void stopPublished(SiteLatch site, ActiveStop stop, @Nullable BotException problem) {
        synchronized (this) {
            if (problem == null) {
                report(site, "");
                return;
            }
            stop.sites.remove(site);
            if (active.containsValue(stop)) {
                report(
                        site,
                        problem instanceof PublicationRefused refused ? site.stopRefused(refused) : site.stopWaits());
            }
        }
    }

    /** Reports why the STOP of this desk has not reached a site; empty if it has. */
    private void report(SiteLatch site, String problem) {
        String before = problem.isEmpty() ? unreached.remove(site) : unreached.put(site, problem);
        if (!problem.equals(before == null ? "" : before)) {
            String all = String.join(" ", new LinkedHashSet<>(unreached.values()));
            runAsync(site, "reporting STOP", () -> {
                team.reportSharedStop(all);
                if (!problem.isEmpty()) {
                    team.notice(problem);
                }
            });
        }
    }

    private static void runAsync(SiteLatch site, String what, Runnable task) {
        site.connection().time().runAsync(what, task);
    }

    /**
     * Publishes the release of what the team was stopped for; a STOP that has just arrived is not released by it. The
     * team is released when all sites that have these STOPs have taken the release, and stays latched if one refuses.
     */
    @Override
    public void release(Runnable decided) {
        List<String> apart = new ArrayList<>();
        synchronized (this) {
            Release release = new Release(latchedIds(), decided);
            sitesOf(release.ids).forEach(site -> publish(site, release, apart));
            if (release.open > 0) {
                releases.add(release);
                return;
            }
            active.keySet().removeAll(release.ids);
            if (!apart.isEmpty()) {
                known.removeAll(release.ids);
            }
        }
        takeEffect();
        apart.forEach(team::notice);
        decided.run();
    }

    private List<String> latchedIds() {
        return active.entrySet().stream()
                .filter(stop -> stop.getValue().latched)
                .map(Map.Entry::getKey)
                .toList();
    }

    private Set<SiteLatch> sitesOf(List<String> ids) {
        Set<SiteLatch> all = new LinkedHashSet<>(sites);
        all.removeIf(site -> ids.stream().noneMatch(id -> isAt(site, id)));
        return all;
    }

    private boolean isAt(SiteLatch site, String id) {
        ActiveStop stop = active.get(id);
        return stop != null && stop.sites.contains(site);
    }

    private void publish(SiteLatch site, Release release, List<String> apart) {
        LatchMessage message = LatchMessage.release(release.ids, site.sender());
        if (site.publish(message, problem -> released(site, release, problem))) {
            release.open++;
        } else {
            apart.add(site.releasedApart());
        }
    }

    private void released(SiteLatch site, Release release, @Nullable BotException problem) {
        synchronized (this) {
            release.open--;
            if (problem != null && sitesOf(release.ids).contains(site)) {
                release.refusal = site.releaseRefused(problem);
            }
            if (release.open > 0) {
                return;
            }
            releases.remove(release);
            release.received |= release.refusal.isEmpty();
            if (release.received) {
                active.keySet().removeAll(release.ids);
            }
        }
        runAsync(site, "release", () -> {
            if (release.received) {
                takeEffect();
            } else {
                team.notice(release.refusal);
            }
            release.decided.run();
        });
    }

    /** Releases the team, unless a STOP has come since the release was decided. */
    private void takeEffect() {
        synchronized (this) {
            if (!active.isEmpty()) {
                return;
            }
            releasesTakingEffect++;
            unreached.clear();
        }
        team.releaseAlone();
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
            ActiveStop present = active.get(message.id());
            if (present != null) {
                present.sites.add(site);
            }
            if (known.contains(message.id())) {
                return;
            }
            addKnown(message.id());
            ActiveStop stop = new ActiveStop(message, null);
            stop.sites.add(site);
            active.put(message.id(), stop);
            stopsOfOthers++;
        }
        StopOrigin origin = new StopOrigin(message.by(), message.time());
        runAsync(site, "STOP of another desk", () -> team.stopAll(origin));
    }

    private void receivedRelease(SiteLatch site, LatchMessage message) {
        boolean latchedStill;
        synchronized (this) {
            message.releases().forEach(this::addKnown);
            List<Release> same = releases.stream()
                    .filter(release -> message.releases().containsAll(release.ids))
                    .toList();
            same.forEach(release -> release.received = true);
            if (active.isEmpty() || !same.isEmpty()) {
                return;
            }
            active.keySet().removeAll(message.releases());
            latchedStill = !active.isEmpty();
        }
        if (latchedStill) {
            repeat(site);
        } else {
            runAsync(site, "release by another desk", () -> {
                takeEffect();
                if (!team.isLatched()) {
                    team.notice("released by " + message.by());
                }
            });
        }
    }
}
