export type Scalar = "half" | "float" | "double" | "exact";
export type Method = "brute" | "pieces" | "boxes" | "circles" | "lin-canny";
export type Point = number[];

export interface Options {
  /** The name of the text in problems; "<stdin>" if not given. `trace` takes a name that ends with ".toml" for that of a lesson. */
  name?: string;
  /** Arithmetic for sets of points; "double" if not given. */
  scalar?: Scalar;
  /** How outlines are answered for; "boxes" if not given. `trace` knows no "brute". */
  method?: Method;
}

/** Points, whose hulls count, or outlines; texts may have any form that `gjkscope solve` reads. */
export interface Case {
  dimension?: 2 | 3;
  a?: (number | string)[][];
  b?: (number | string)[][];
  outlines_a?: unknown[];
  outlines_b?: unknown[];
  name?: string;
}

/** An answer of `gjkscope solve`: with `error`, or with `distance`. A number that exceeds the largest is null. */
export interface Solved {
  case: string;
  understood?: string;
  error?: string;
  distance?: number | null;
  overlap?: boolean | null;
  a?: Point;
  b?: Point;
  // Sets of points
  scalar?: Scalar;
  lower?: number | null;
  upper?: number | null;
  /** A rational number, as exact runs have them. */
  distance_squared?: string;
  verdict?: string;
  settled?: boolean;
  iterations?: number;
  stop?: string;
  // Sets of points in the plane that overlap
  depth?: number | null;
  depth_lower?: number | null;
  depth_upper?: number | null;
  direction?: Point;
  translation?: Point;
  // Outlines
  method?: Method;
  features?: Record<"a" | "b", { kind: "vertex" | "segment"; outline: number; index: number } | null>;
  visits?: number;
}

/** A trace, as docs/trace-format.md of gjkscope describes it. */
export type Trace = Record<string, unknown>;

export interface Finding {
  /** None where it is about the answer. */
  iteration?: number;
  line: number;
  part: "vertex" | "drop" | "weights" | "closest" | "direction" | "support" | "stop" | "answer";
  what?: string;
}

export interface Judgement {
  log: string;
  right: boolean;
  iterations: number;
  distance: number;
  overlap: boolean;
  wrong: Finding | null;
  wrong_answer: Finding | null;
  waste: Finding | null;
  rounding: number;
  rounded: Finding | null;
  cut_off: boolean;
}

/** The distance of each case: the answers of `gjkscope solve`, to the last bit. A case that has none has `error`. */
export function solve(cases: string | Case | Case[], options?: Options): Promise<Solved[]>;

/** The run of each case that can be read, or of a lesson's text, as `gjkscope trace --json` has it. Rejects where there is none. */
export function trace(cases: string | Case | Case[], options?: Options): Promise<Trace[]>;

/** The first wrong step in a log of any GJK, as `gjkscope judge --json` finds it. Rejects a log that cannot be read. */
export function judge(log: string, options?: Pick<Options, "name">): Promise<Judgement>;

/** The output of the command for the text, byte for byte: `out` on standard output, `err` on standard error. */
export function printed(
  command: "solve" | "trace" | "judge", text: string | Case | Case[], options?: Options): Promise<{ out: string; err: string }>;
