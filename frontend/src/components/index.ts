export { Button, type ButtonProps } from "./Button";
export { AskDialog, ask, Dialog } from "./Dialog";
export { DropFiles } from "./DropFiles";
export { Empty, JobProgress, Loading, Notice, Problem, Progress } from "./Feedback";
export { Field, Segments, SelectField, TextField } from "./Field";
export { Icon, type IconName } from "./Icon";
export { Menu } from "./Menu";
export { type MarkShape, Shape, StateMark, type StateName, stateWord } from "./StateMark";
