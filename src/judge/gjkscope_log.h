#ifndef GJKSCOPE_LOG_H
#define GJKSCOPE_LOG_H
/* Writes a run of any GJK as a log that `gjkscope judge` checks: docs/log-format.md.
 *
 * C99 or C++, this file alone. Nothing is allocated. Every line is flushed, so that a run that
 * crashes, or never ends, leaves what it did before.
 *
 *   gjkscope_log log;
 *   gjkscope_log_begin(&log, file, 2, GJKSCOPE_B_MINUS_A, "double");
 *   for (...) gjkscope_log_vertex(&log, "a", x, y, 0);
 *   for (...) gjkscope_log_vertex(&log, "b", x, y, 0);
 *   for (;;) {
 *     gjkscope_log_iteration(&log);
 *     for (...) gjkscope_log_pair(&log, "simplex", index_in_a, index_in_b);
 *     gjkscope_log_vector(&log, "closest", px, py, 0);
 *     gjkscope_log_vector(&log, "direction", dx, dy, 0);
 *     gjkscope_log_support(&log, index_in_a, index_in_b);
 *   }
 *   gjkscope_log_answer(&log);
 *   gjkscope_log_number(&log, "distance", distance);
 *   gjkscope_log_end(&log);
 *
 * Only the shapes are required: leave out what a loop does not have. Vertices are in the world, not
 * in the frames of their shapes. The entries of one list follow each other, and a list without
 * entries is not written. In the plane the last coordinate is ignored. Numbers that are not finite
 * are written as the strings "nan", "inf" and "-inf", as JSON has none.
 */

#include <stdio.h>
#include <string.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The difference that the loop looks at. */
#define GJKSCOPE_B_MINUS_A "b-a"
#define GJKSCOPE_A_MINUS_B "a-b"

typedef struct gjkscope_log {
  FILE* file;
  int dimension;
  int keys;         /* written on this line */
  const char* list; /* the list that is open, or null */
  const char* end;  /* of this line */
} gjkscope_log;

/* The rest of this part is what the functions below are made of. */

static inline void gjkscope_log_double(gjkscope_log* log, double value) {
  char text[40];
  char* at;
  snprintf(text, sizeof text, "%.17g", value);
  at = text + (text[0] == '-');
  if (*at < '0' || *at > '9') {
    fputs(*at == 'i' || *at == 'I' ? (at == text ? "\"inf\"" : "\"-inf\"") : "\"nan\"", log->file);
    return;
  }
  for (; *at != 0; ++at) {
    if (*at == ',') *at = '.'; /* of the locale */
  }
  fputs(text, log->file);
}

static inline void gjkscope_log_coordinates(gjkscope_log* log, double x, double y, double z) {
  fputc('[', log->file);
  gjkscope_log_double(log, x);
  fputc(',', log->file);
  gjkscope_log_double(log, y);
  if (log->dimension == 3) {
    fputc(',', log->file);
    gjkscope_log_double(log, z);
  }
  fputc(']', log->file);
}

static inline void gjkscope_log_close_list(gjkscope_log* log) {
  if (log->list != NULL) fputc(']', log->file);
  log->list = NULL;
}

static inline void gjkscope_log_key(gjkscope_log* log, const char* key) {
  gjkscope_log_close_list(log);
  fprintf(log->file, log->keys++ == 0 ? "\"%s\":" : ",\"%s\":", key);
}

static inline void gjkscope_log_entry(gjkscope_log* log, const char* list) {
  if (log->list != NULL && strcmp(log->list, list) == 0) {
    fputc(',', log->file);
  } else {
    gjkscope_log_key(log, list);
    fputc('[', log->file);
    log->list = list;
  }
}

/* Ends a line and begins the next. */
static inline void gjkscope_log_line(gjkscope_log* log, const char* begin, const char* end) {
  gjkscope_log_close_list(log);
  fputs(log->end, log->file);
  fflush(log->file);
  fputs(begin, log->file);
  log->keys = 0;
  log->end = end;
}

/* Begins a log. `dimension` is 2 or 3; `difference` one of the two above; `scalar` what the loop
 * computes in: "double", "float" or "half". */
static inline void gjkscope_log_begin(gjkscope_log* log, FILE* file, int dimension,
                                      const char* difference, const char* scalar) {
  log->file = file;
  log->dimension = dimension;
  log->list = NULL;
  log->end = "}\n";
  log->keys = 3;
  fprintf(file, "{\"gjk_log\":1,\"difference\":\"%s\",\"scalar\":\"%s\"", difference, scalar);
}

/* The next vertex of shape "a" or "b": all of the one, then all of the other. */
static inline void gjkscope_log_vertex(gjkscope_log* log, const char* shape, double x, double y,
                                       double z) {
  gjkscope_log_entry(log, shape);
  gjkscope_log_coordinates(log, x, y, z);
}

/* Begins an iteration. */
static inline void gjkscope_log_iteration(gjkscope_log* log) { gjkscope_log_line(log, "{", "}\n"); }

/* The next vertex of the list "simplex" (before anything is dropped) or "kept" (after). */
static inline void gjkscope_log_pair(gjkscope_log* log, const char* list, int index_in_a,
                                     int index_in_b) {
  gjkscope_log_entry(log, list);
  fprintf(log->file, "[%d,%d]", index_in_a, index_in_b);
}

/* The same as the difference that the loop has: "points" or "kept_points". */
static inline void gjkscope_log_point(gjkscope_log* log, const char* list, double x, double y,
                                      double z) {
  gjkscope_log_entry(log, list);
  gjkscope_log_coordinates(log, x, y, z);
}

/* The next weight: one for each vertex that is kept, where that is logged, else of the simplex. */
static inline void gjkscope_log_weight(gjkscope_log* log, double weight) {
  gjkscope_log_entry(log, "weights");
  gjkscope_log_double(log, weight);
}

/* "closest", "direction" (from the closest point to the origin) or "support_point"; in the answer
 * "a" or "b", the closest points of the shapes, or "translation", by which a moves until shapes
 * that overlap just touch. */
static inline void gjkscope_log_vector(gjkscope_log* log, const char* key, double x, double y,
                                       double z) {
  gjkscope_log_key(log, key);
  gjkscope_log_coordinates(log, x, y, z);
}

static inline void gjkscope_log_support(gjkscope_log* log, int index_in_a, int index_in_b) {
  gjkscope_log_key(log, "support");
  fprintf(log->file, "[%d,%d]", index_in_a, index_in_b);
}

/* Begins the answer, of which each part may be left out. */
static inline void gjkscope_log_answer(gjkscope_log* log) {
  gjkscope_log_line(log, "{\"answer\":{", "}}\n");
}

/* "distance", or "depth", which is as long as the translation. */
static inline void gjkscope_log_number(gjkscope_log* log, const char* key, double value) {
  gjkscope_log_key(log, key);
  gjkscope_log_double(log, value);
}

static inline void gjkscope_log_overlap(gjkscope_log* log, int overlap) {
  gjkscope_log_key(log, "overlap");
  fputs(overlap ? "true" : "false", log->file);
}

/* Ends the log, after its answer or without one. */
static inline void gjkscope_log_end(gjkscope_log* log) { gjkscope_log_line(log, "", ""); }

#ifdef __cplusplus
}
#endif

#endif
