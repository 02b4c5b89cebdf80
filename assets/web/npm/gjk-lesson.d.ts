export type Theme = "auto" | "light" | "dark" | "high-contrast" | "print";

export interface StepDetail {
  lesson: string;
  /** From 1. */
  step: number;
  /** How many steps there are. */
  count: number;
  /** The place in the run, such as "Iteration 2: support". */
  position: string;
  /** The words: what happens there, and why. */
  caption: string;
}

export interface AnswerDetail {
  lesson: string;
  step: number;
  chosen: string;
  /** The answer of the run. */
  answer: string;
  right: boolean;
  /** Questions that were answered so far, and how many rightly. */
  asked: number;
  correct: number;
}

export interface ProblemDetail {
  lesson: string;
  message: string;
}

export interface GjkLessonEventMap {
  /** The figure can be stepped. */
  ready: CustomEvent<StepDetail>;
  /** Another step is shown. */
  step: CustomEvent<StepDetail>;
  /** A question was answered. */
  answer: CustomEvent<AnswerDetail>;
  /** There is no figure, and why. */
  problem: CustomEvent<ProblemDetail>;
}

/** `<gjk-lesson lesson="polygons-gjk" step="12" theme="auto">`; events bubble. */
export class GjkLesson extends HTMLElement {
  /** The id of a lesson, a key of `lessons`; or "playground". */
  lesson: string;
  /** The step that is shown, from 1; another value goes there. */
  step: number;
  /** How many steps there are; 0 until the figure is ready. */
  readonly count: number;
  /** Asks before each step is shown, where the run can be asked about. */
  ask: boolean;
  /** "auto" follows the system. */
  theme: Theme;
  addEventListener<K extends keyof GjkLessonEventMap>(
    type: K, listener: (this: GjkLesson, event: GjkLessonEventMap[K]) => void, options?: boolean | AddEventListenerOptions): void;
  addEventListener(type: string, listener: EventListenerOrEventListenerObject, options?: boolean | AddEventListenerOptions): void;
}

/** Titles of the lessons, by id. */
export const lessons: Readonly<Record<string, string>>;

declare global {
  interface HTMLElementTagNameMap {
    "gjk-lesson": GjkLesson;
  }
}
