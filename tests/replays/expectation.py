"""What a golden replay must show: replays/NAME.expect, one `key = value` a line; `#` starts a comment, and the comment
before the first key says what the replay guards.

    ticks = 3600                            at least; so for all numbers. ticks, kills, over are required
    kills = 500
    kills.vertex = 100                      of one type
    kills.texel = none                      not a single one; so for all numbers
    peakEnemies, refused, contacts, flushes, shots, bitsTaken, score, travelled_m
    mode = arcade                           the mode's name
    over = frame_rate                       how it ends: frame_rate, time_up, cleared; no: it does not
    edge = group: attacking -> grouping     this state change happens; as often as needed
    edges = tricky                          every one of this machine; all: of all three

Of the inputs, which replay_facts tells:
    squareSticks_ticks, halfTurns, presses, allButtons_ticks, analogueMoves_ticks, keyMoves_ticks, idle_ticks
and of what no report tells, for which it plays the replay itself:
    corners                                 how many of the world's four the ship has been in
    atOnePlace                              the most living enemies that stood at exactly one place
    alone_ticks                             without any enemy
"""
REPORTED = ("ticks", "kills", "peakEnemies", "refused", "contacts", "flushes", "shots", "bitsTaken", "score",
            "travelled_m")
OF_INPUTS = ("squareSticks_ticks", "halfTurns", "presses", "allButtons_ticks", "analogueMoves_ticks", "keyMoves_ticks",
             "idle_ticks")
PLAYED = ("corners", "atOnePlace", "alone_ticks")
NUMBERS = REPORTED + OF_INPUTS + PLAYED
ENDINGS = ("frame_rate", "time_up", "cleared", "no")
MODES = ("arcade", "deadline", "swarm", "practice")
REQUIRED = ("ticks", "kills", "over")
REPEATED = ("edge", "edges")
NONE = "none"


class Expectation:
    """One .expect file. Raises ValueError, one sentence, when it is missing or wrong."""

    def __init__(self, path):
        self.values, self.edges, guards = {}, [], []
        if not path.is_file():
            raise ValueError(f"{path} is missing: write down there what the replay must show")
        for number, line in enumerate(path.read_text().splitlines(), 1):
            if line.startswith("#") and not self.values and not self.edges:
                guards.append(line.strip("# "))
            line = line.partition("#")[0].strip()
            if line:
                try:
                    self._add(*(part.strip() for part in line.partition("=")))
                except ValueError as error:
                    raise ValueError(f"{path}:{number}: {error}") from None
        self.guards = " ".join(guards)
        for key in REQUIRED:
            if key not in self.values:
                raise ValueError(f"{path}: '{key}' is missing; a replay that need not show it shows nothing")

    def _add(self, key, equals, value):
        if not equals:
            raise ValueError(f"'{key}' has no value; write key = value")
        if key in REPEATED:
            self.edges.append((key, value))
            return
        if key in self.values:
            raise ValueError(f"'{key}' stands twice; keep one")
        words = {"over": ENDINGS, "mode": MODES}.get(key)
        if words:
            if value not in words:
                raise ValueError(f"'{key}' is one of {', '.join(words)}, not '{value}'")
            self.values[key] = value
        elif key in NUMBERS or (key.startswith("kills.") and key != "kills."):
            if value == NONE:
                self.values[key] = 0
            elif not value.isascii() or not value.isdigit() or int(value) == 0:
                raise ValueError(f"'{key}' takes a whole number from 1 or {NONE}, not '{value}'")
            else:
                self.values[key] = int(value)
        else:
            raise ValueError(f"there is no key '{key}'; tests/replays/expectation.py lists them")

    def asks_inputs(self):
        return any(key in OF_INPUTS for key in self.values)

    def asks_played(self):
        return any(key in PLAYED for key in self.values)

    def unmet(self, facts):
        """Sentences on what a verified run lacks; `facts` is its entry in the output of verify --json, and what
        replay_facts adds to it."""
        lacks = []
        for key, wanted in self.values.items():
            if key == "over":
                is_so = facts["ending"] if facts["over"] else "no"
            elif key == "mode":
                is_so = facts["mode"]
            elif key.startswith("kills."):
                name = key.removeprefix("kills.")
                if name not in facts["killsByType"]:
                    lacks.append(f"{key}: there is no such type; there are {', '.join(facts['killsByType'])}")
                    continue
                is_so = facts["killsByType"][name]
            else:
                is_so = facts[key]
            if isinstance(wanted, str) and is_so != wanted:
                lacks.append(f"{key} must be {wanted}, is {is_so}")
            elif wanted == 0 and is_so != 0:
                lacks.append(f"{key} must be {NONE}, is {is_so}")
            elif isinstance(wanted, int) and is_so < wanted:
                lacks.append(f"{key} must be at least {wanted}, is {is_so}")
        for key, value in self.edges:
            lacks += self._unmet_edge(value, facts["edges"]) if key == "edge" else self._unmet_edges(value, facts["edges"])
        return lacks

    @staticmethod
    def _unmet_edge(value, machines):
        machine, _, edge = (part.strip() for part in value.partition(":"))
        if machine not in machines:
            return [f"edge '{value}': there is no machine '{machine}'; there are {', '.join(machines)}"]
        if edge not in machines[machine]:
            return [f"edge '{value}': no such edge; {machine} has {', '.join(machines[machine])}"]
        return [] if machines[machine][edge] else [f"edge '{value}' is never taken"]

    @staticmethod
    def _unmet_edges(value, machines):
        if value != "all" and value not in machines:
            return [f"edges '{value}': there is no such machine; there are {', '.join(machines)}, or all"]
        return [f"edge '{machine}: {edge}' is never taken" for machine in machines if value in ("all", machine)
                for edge, count in machines[machine].items() if count == 0]


def shown(facts, guards):
    """The text of an .expect that asks for what a run shows; a person may trim it."""
    lines = [f"# {guards}", f"mode = {facts['mode']}", f"over = {facts['ending'] if facts['over'] else 'no'}"]
    for key in REPORTED:
        lines.append(f"{key} = {int(facts[key]) or NONE}")
    lines += [f"kills.{name} = {count or NONE}" for name, count in facts["killsByType"].items()]
    for machine, edges in facts["edges"].items():
        if all(edges.values()):
            lines.append(f"edges = {machine}")
        else:
            lines += [f"edge = {machine}: {edge}" for edge, count in edges.items() if count]
    return "\n".join(lines) + "\n"
