#pragma once
// The keys of every lesson file, table by table, in the order in which they are listed and written.

#include <vector>

#include "lesson/key_pass.hpp"
#include "lesson/lesson.hpp"

namespace gjkscope {

void head_keys(KeyPass& keys, Lesson& lesson);
void query_keys(KeyPass& keys, Lesson& lesson);
void steps_keys(KeyPass& keys, Lesson& lesson);
void panel_keys(KeyPass& keys, Lesson& lesson);
void shape_keys(KeyPass& keys, LessonShape& shape);
void path_keys(KeyPass& keys, LessonPath& path);
void y_path_keys(KeyPass& keys, LessonMotion& motion);
void view_keys(KeyPass& keys, LessonView& view);
void camera_keys(KeyPass& keys, Camera& camera);
void eye_keys(KeyPass& keys, Eye& eye);
void close_up_keys(KeyPass& keys, CloseUp& close_up);
void question_keys(KeyPass& keys, LessonQuestion& question);
void expect_keys(KeyPass& keys, Expectation& expect);

/// All of these tables.
[[nodiscard]] std::vector<LessonKey> own_keys();

}  // namespace gjkscope
