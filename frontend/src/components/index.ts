export { Button, IconButton } from "./Button";
export { Checklist } from "./Checklist";
export { type Choice, choices, named } from "./choices";
export { AskDialog, ask, Dialog } from "./Dialog";
export { DropFiles } from "./DropFiles";
export { type Fact, Facts } from "./Facts";
export { Empty, JobProgress, Loaded, Loading, Notice, Notices, Problem, Progress } from "./Feedback";
export {
  Check,
  DateField,
  Field,
  OptionalField,
  Segments,
  Select,
  SelectField,
  TextControl,
  TextField,
} from "./Field";
export { FormDialog } from "./FormDialog";
export { Icon, type IconName } from "./Icon";
export { LanguageChoice } from "./LanguageChoice";
export { LongList } from "./LongList";
export { Mark } from "./Mark";
export { Menu } from "./Menu";
export { PageHead, Panel } from "./Panel";
export { Remark } from "./Remark";
export { ShowOnce } from "./ShowOnce";
export { type MarkShape, Shape, StateMark } from "./StateMark";
export { type Column, type Columns, DataTable, num, Table } from "./Table";
export { TableScroll } from "./TableScroll";
