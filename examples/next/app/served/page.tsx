import { Served } from './Served';

export default function Page() {
  return <Served />;
}
